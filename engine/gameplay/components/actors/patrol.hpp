#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Walks to and fro: turns at walls, at edges, and at limits. Needs a KinematicBody or a RigidBody.
struct Patrol {
    float speed = 40.0f;      ///< px/s
    float leftLimit = 0.0f;   ///< px, how far it goes left from where it began; 0 for any
    float rightLimit = 0.0f;  ///< px, how far it goes right; 0 for any
    bool turnAtEdges = true;  ///< before it would fall
    bool turnAtWalls = true;
    bool startLeft = true;   ///< goes left first
    bool facesLeft = false;  ///< its picture looks left when not flipped
    int direction = 0;       ///< 1 right, -1 left, 0 not started
    float homeX = 0.0f;      ///< px, where it began

    static void describe(TypeBuilder<Patrol>& type) {
        type.name("Patrol").doc(
            "Walks to and fro: turns at walls, at edges, and at limits. Needs a KinematicBody or a "
            "RigidBody.");
        type.field<&Patrol::speed>("speed").unit(Unit::PixelsPerSecond).range(0.0f, 10000.0f);
        type.field<&Patrol::leftLimit>("leftLimit")
            .unit(Unit::Pixels)
            .range(0.0f, 100000.0f)
            .doc("How far it goes left from where it began; 0 for any.");
        type.field<&Patrol::rightLimit>("rightLimit")
            .unit(Unit::Pixels)
            .range(0.0f, 100000.0f)
            .doc("How far it goes right; 0 for any.");
        type.field<&Patrol::turnAtEdges>("turnAtEdges").doc("Before it would fall.");
        type.field<&Patrol::turnAtWalls>("turnAtWalls");
        type.field<&Patrol::startLeft>("startLeft").doc("Goes left first.");
        type.field<&Patrol::facesLeft>("facesLeft").doc("Its picture looks left when not flipped.");
        type.field<&Patrol::direction>("direction").transient();
        type.field<&Patrol::homeX>("homeX").unit(Unit::Pixels).transient();
    }
};

}  // namespace plumb
