#pragma once

#include <cstring>

#include <gtest/gtest.h>

#include "physics/model/field.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics::test {

inline constexpr float kStep = 1.0f / 60.0f;  // time step, s

/// Makes a world with gravity 10 m/s2 downwards (y points down) in which no body falls asleep.
inline World makeWorld() {
    World world;
    world.settings.sleeping = false;
    return world;
}

/// Makes a world without gravity in which no body falls asleep.
inline World makeSpace() {
    World world = makeWorld();
    world.settings.gravity = {};
    return world;
}

inline FieldDefinition fieldOf(FieldKind kind) {
    FieldDefinition field;
    field.kind = kind;
    return field;
}

inline BodyId addBody(World& world, BodyKind kind, WorldPosition place, const Geometry& outline,
                      const ShapeDefinition& shape = {}, BodyDefinition body = {}) {
    body.kind = kind;
    body.position = place;
    const BodyId id = *createBody(world, body);
    EXPECT_TRUE(createShape(world, id, outline, shape).ok());
    return id;
}

/// Adds a floor whose top is at y = 0.
inline BodyId addFloor(World& world, const ShapeDefinition& shape = {}) {
    return addBody(world, BodyKind::Static, {0.0, 1.0}, box({100.0f, 1.0f}), shape);
}

inline void run(World& world, int steps) {
    for (int i = 0; i < steps; ++i) step(world, kStep);
}

inline double heightOf(const World& world, BodyId body) { return -positionOf(world, body).y; }  // y up, m

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// True if all poses and velocities are equal bit for bit.
inline bool sameState(const World& a, const World& b) {
    return sameBytes(a.bodies.pose, b.bodies.pose) && sameBytes(a.bodies.motion, b.bodies.motion);
}

}  // namespace plumb::physics::test
