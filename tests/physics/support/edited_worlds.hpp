#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "world_of_bodies.hpp"

namespace plumb::physics {

// Helpers for worlds whose bodies, shapes and joints are edited between steps.

template <class T>
inline bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Expects equal positions up to `tolerance`, m, the same effects in use and equally many contacts.
inline void expectNear(const World& a, const World& b, double tolerance = 1.0e-6) {
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        EXPECT_NEAR(a.bodies.pose[i].centre.x, b.bodies.pose[i].centre.x, tolerance) << i;
        EXPECT_NEAR(a.bodies.pose[i].centre.y, b.bodies.pose[i].centre.y, tolerance) << i;
    }
    EXPECT_EQ(a.manifest.requesters, b.manifest.requesters);
    EXPECT_EQ(a.qualityCallers, b.qualityCallers);
    EXPECT_EQ(a.contacts.size(), b.contacts.size());
}

/// Expects poses, velocities and masses that are equal bit for bit.
inline void expectSame(const World& a, const World& b) {
    EXPECT_TRUE(sameBytes(a.bodies.pose, b.bodies.pose));
    EXPECT_TRUE(sameBytes(a.bodies.motion, b.bodies.motion));
    EXPECT_TRUE(sameBytes(a.bodies.mass, b.bodies.mass));
    expectNear(a, b);
}

inline void run(World& world, int steps) {
    for (int i = 0; i < steps; ++i) step(world, kTick);
}

inline BodyId bodyAt(const World& world, std::uint32_t index) {
    return {index, world.bodies.info[index].generation};
}
inline ShapeId shapeAt(const World& world, std::uint32_t index) {
    return {index, world.shapes.info[index].generation};
}

inline ShapeDefinition randomDefinition(Random& random) {
    ShapeDefinition d;
    d.density = random.between(0.5f, 3.0f);
    d.friction = random.below(3) == 0 ? 0.0f : random.between(0.1f, 1.0f);
    d.bounciness = random.below(3) == 0 ? random.unit() : 0.0f;
    d.rollingResistance = random.below(3) == 0 ? 0.1f : 0.0f;
    d.surfaceSpeed = random.below(4) == 0 ? 1.0f : 0.0f;
    d.layers = 1 + random.below(3);
    d.isTrigger = random.below(5) == 0;
    d.oneWay = random.below(5) == 0;
    d.reportsContacts = random.below(2) == 0;
    d.user = random.below(100);
    return d;
}

/// @param exact  true: the center of mass is exactly at the origin of the body
inline Geometry randomGeometry(Random& random, bool exact = false) {
    const float size = random.between(0.3f, 0.6f);
    if (exact && random.below(2) == 0) return box({size, random.between(0.2f, 0.6f)});
    switch (exact ? 0 : random.below(3)) {
        case 0: return circle(size);
        case 1: return capsule({-size, 0.0f}, {size, 0.0f}, 0.5f * size);
        default: return box({size, random.between(0.2f, 0.6f)}, {}, rotFromAngle(random.unit()));
    }
}

/// Builds a floor (body 0, shape 0) and a heap of `count` bodies with one shape each: body i has shape i.
inline World heap(int count, const std::function<BodyKind(int)>& kindOf,
                  const std::function<ShapeDefinition(int)>& definitionOf,
                  const std::function<Geometry(int)>& geometryOf) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    const BodyId ground = addBody(world, BodyKind::Static, {0.0, -1.0});
    static_cast<void>(createShape(world, ground, box({20.0f, 1.0f})));
    for (int i = 0; i < count; ++i) {
        const BodyId body = addBody(world, kindOf(i), {-3.0 + 1.1 * (i % 6), 0.7 + 1.2 * (i / 6)},
                                    0.3f * static_cast<float>(i));
        EXPECT_TRUE(createShape(world, body, geometryOf(i), definitionOf(i)).ok());
    }
    return world;
}

inline BodyKind dynamic(int) { return BodyKind::Dynamic; }

/// Applies a random edit to a random body, shape or joint. Rejected edits are ignored.
inline void applyRandomEdit(World& world, Random& random) {
    const auto bodies = static_cast<std::uint32_t>(world.bodies.size());
    const BodyId body = bodyAt(world, random.below(bodies));
    const ShapeId shape = shapeAt(world, random.below(static_cast<std::uint32_t>(world.shapes.size())));
    const bool hasJoints = !world.joints.hot.empty();
    const std::uint32_t j = hasJoints ? random.below(static_cast<std::uint32_t>(world.joints.size())) : 0;
    const JointId joint = hasJoints ? JointId{j, world.joints.hot[j].generation} : JointId{};
    const auto ignore = [](const auto& result) { static_cast<void>(result.ok()); };
    switch (random.below(14)) {
        case 0: return ignore(setKind(world, body, static_cast<BodyKind>(1 + random.below(3))));
        case 1: return setEnabled(world, body, random.below(2) == 0);
        case 2: return ignore(setGeometry(world, shape, randomGeometry(random)));
        case 3: return ignore(setDefinition(world, shape, randomDefinition(random)));
        case 4:
            return ignore(setMassData(
                world, body, {random.between(0.0f, 3.0f), {random.between(-0.2f, 0.2f), 0.0f}, 0.3f}));
        case 5: return ignore(applyAngularImpulse(world, body, random.between(-1.0f, 1.0f)));
        case 6: return ignore(setSleepSpeed(world, body, random.between(0.0f, 0.5f)));
        case 7: return setAwake(world, body, random.below(2) == 0);
        case 8: return destroyShape(world, shape);
        case 9: return ignore(setMass(world, body, random.between(0.0f, 2.0f)));
        case 10:
            return ignore(change(world, joint, [&](JointDefinition& d) {
                d.limit = {random.below(2) == 0, -0.5f, 0.5f};
                d.motor = {random.below(2) == 0, random.between(-2.0f, 2.0f), 50.0f};
                d.spring = {random.below(2) == 0, 3.0f, 0.5f, 0.0f};
                d.anchorA.x += 0.05f;
                d.collideConnected = random.below(2) == 0;
                d.hertz = random.below(2) == 0 ? 0.0f : 5.0f;
            }));
        case 11: {
            JointDefinition d;
            d.kind = static_cast<JointKind>(random.below(static_cast<std::uint32_t>(JointKind::Count)));
            d.a = body;
            d.b = bodyAt(world, random.below(bodies));
            d.anchorB = localPoint(world, d.b, worldPoint(world, d.a, {}));
            return ignore(createJoint(world, d));
        }
        case 12: return clearForces(world, body);
        default: return ignore(applyForce(world, body, {random.between(-20.0f, 20.0f), 0.0f}));
    }
}

/// A crate that sleeps on a static shelf.
struct Shelf {
    World world;
    BodyId shelf, crate;
    ShapeId board;

    Shelf() {
        world.settings.gravity = {0.0f, -10.0f};
        shelf = addBody(world, BodyKind::Static, {0.0, 0.0});
        board = *createShape(world, shelf, box({1.0f, 0.1f}));
        crate = addBody(world, BodyKind::Dynamic, {0.5, 0.6});
        static_cast<void>(createShape(world, crate, box({0.2f, 0.5f})));
        run(world, 120);
        EXPECT_FALSE(isAwake(world, crate));
    }
};

}  // namespace plumb::physics
