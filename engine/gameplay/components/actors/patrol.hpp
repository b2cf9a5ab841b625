#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

/// Walks back and forth; reverses direction at walls,
/// ledges and limits. Needs a KinematicBody or a RigidBody.
struct Patrol {
    float speed = 40.0f;      ///< px/s, walking speed
    float leftLimit = 0.0f;   ///< px, maximum distance to the left of the initial position; 0: unlimited
    float rightLimit = 0.0f;  ///< px, maximum distance to the right of the initial position; 0: unlimited
    bool turnAtEdges = true;  ///< reverse direction at ledges, before falling
    bool turnAtWalls = true;  ///< reverse direction at walls
    bool startLeft = true;    ///< walk to the left first
    bool facesLeft = false;   ///< the unflipped sprite faces left
    int direction = 0;        ///< 1 right, -1 left, 0 not started
    float homeX = 0.0f;       ///< px, initial x position

    static void describe(TypeBuilder<Patrol>& type) {
        type.name("Patrol").doc(
            "Walks back and forth; reverses direction at walls, ledges and limits. Needs a KinematicBody or "
            "a "
            "RigidBody.");
        type.field<&Patrol::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 10000.0f)
            .doc("Walking speed, px/s.");
        type.field<&Patrol::leftLimit>("leftLimit")
            .unit(Unit::Pixels)
            .range(0.0f, 100000.0f)
            .doc("Maximum distance to the left of the initial position, px; 0: unlimited.");
        type.field<&Patrol::rightLimit>("rightLimit")
            .unit(Unit::Pixels)
            .range(0.0f, 100000.0f)
            .doc("Maximum distance to the right of the initial position, px; 0: unlimited.");
        type.field<&Patrol::turnAtEdges>("turnAtEdges").doc("Reverses direction at ledges, before falling.");
        type.field<&Patrol::turnAtWalls>("turnAtWalls").doc("Reverses direction at walls.");
        type.field<&Patrol::startLeft>("startLeft").doc("Walks to the left first.");
        type.field<&Patrol::facesLeft>("facesLeft").doc("The unflipped sprite faces left.");
        type.field<&Patrol::direction>("direction").transient();
        type.field<&Patrol::homeX>("homeX").unit(Unit::Pixels).transient();
    }
};

}  // namespace plumb
