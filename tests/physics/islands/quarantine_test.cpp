#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "physics/ranges.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/joint_world.hpp"

// A body with non-finite numbers is frozen at its position and does not affect other bodies.

namespace plumb::physics {
namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kEndless = std::numeric_limits<float>::infinity();

bool areSound(const World& world, SoftBodyId soft) {
    return std::ranges::all_of(particlesOf(world, soft), [&](const SoftParticle& p) {
        return std::isfinite(p.place.x) && std::isfinite(p.place.y) &&
               length(p.velocity) <= 1.0001f * world.settings.maxSpeed;
    });
}

/// A box that hangs from a joint, with a cloth on top.
struct UnderACloth {
    JointWorld scene;
    BodyId body;
    SoftBodyId cloth;
    JointId joint;

    UnderACloth() {
        BodyDefinition definition;
        body = *createBody(scene.world, definition);
        (void)*createShape(scene.world, body, box({1.0f, 0.5f}));
        cloth = *createCloth(scene.world, {-1.0, 0.6}, {2.0f, 0.5f}, 7, 3);
        definition.kind = BodyKind::Kinematic;
        definition.velocity = {0.5f, 0.0f};
        const BodyId leaving = *createBody(scene.world, definition);
        joint = scene.join(scene.define(JointKind::Revolute, leaving, body, {0.0, 0.0}));
    }
};

TEST(Quarantine, ofABodyDoesNotSpread) {
    for (const float bad : {kNoNumber, kEndless}) {
        SCOPED_TRACE(bad);
        UnderACloth under;
        World& world = under.scene.world;
        under.scene.run(1.0f);
        const Vec2 place = under.scene.place(under.body);
        world.bodies.motion[under.body.index].velocity = {bad, 0.0f};

        step(world, JointWorld::kDt);
        ASSERT_EQ(world.quarantined.size(), 1u);
        EXPECT_EQ(world.quarantined[0], under.body);
        EXPECT_EQ(under.scene.place(under.body), place);
        EXPECT_EQ(velocityOf(world, under.body), Vec2{});
        EXPECT_TRUE(isFinite(jointForce(world, under.joint)));
        EXPECT_TRUE(areSound(world, under.cloth));

        for (int i = 0; i < 60; ++i) {
            step(world, JointWorld::kDt);
            EXPECT_TRUE(world.quarantined.empty());
            EXPECT_TRUE(isFinite(jointForce(world, under.joint)));
            EXPECT_TRUE(areSound(world, under.cloth));
        }
        EXPECT_NEAR(velocityOf(world, under.body).x, 0.5f, 0.05f);
    }
}

TEST(Quarantine, stopsBodiesAtTheFarthestDistance) {
    World world;
    world.settings.gravity = {};
    const BodyId body = *createBody(world, {.position = {kFarthest - 5.0, 0.0}, .velocity = {120.0f, 0.0f}});
    static_cast<void>(createShape(world, body, circle(0.5f)));
    for (int i = 0; i < 2; ++i) step(world, JointWorld::kDt);
    EXPECT_TRUE(world.quarantined.empty());
    step(world, JointWorld::kDt);
    ASSERT_EQ(world.quarantined.size(), 1u);
    EXPECT_EQ(world.quarantined[0], body);
    EXPECT_EQ(centreOf(world, body).x, kFarthest - 1.0);
    EXPECT_EQ(velocityOf(world, body).x, 0.0f);
}

TEST(Quarantine, ofAParticleDoesNotSpreadAndIsReported) {
    for (const float bad : {kNoNumber, kEndless}) {
        SCOPED_TRACE(bad);
        UnderACloth under;
        World& world = under.scene.world;
        SoftParticle& particle = world.softBodies.all[under.cloth.index].particles[3];
        particle.velocity = {0.0f, bad};

        step(world, JointWorld::kDt);
        ASSERT_EQ(world.quarantinedSoft.size(), 1u);
        EXPECT_EQ(world.quarantinedSoft[0], under.cloth);
        EXPECT_TRUE(areSound(world, under.cloth));
        EXPECT_TRUE(world.quarantined.empty());

        step(world, JointWorld::kDt);
        EXPECT_TRUE(world.quarantinedSoft.empty());
    }
}

// Regression: a body at Settings::maxSpeed hits a cloth between walls; particles reached 190,000 m/s.
TEST(Quarantine, isNotNeededForParticlesHitByFastBodies) {
    for (int k = 0; k < 60; ++k) {
        SCOPED_TRACE(k);
        World world;
        const BodyId walls = *createBody(world, {.kind = BodyKind::Static});
        for (const float side : {-1.0f, 1.0f}) {
            (void)*createShape(world, walls, box({8.0f, 0.5f}, {0.0f, 6.5f * side}));
            (void)*createShape(world, walls, box({0.5f, 8.0f}, {7.0f * side, 0.0f}));
        }
        const SoftBodyId cloth = *createCloth(world, {-1.5, 0.0}, {3.0f, 1.5f}, 3 + k % 5, 3 + k / 5 % 5,
                                              {.mass = 0.2f + static_cast<float>(k % 7) * 0.7f});
        const float angle = static_cast<float>(k) * 0.37f;
        const BodyId body =
            *createBody(world, {.position = {4.0 * std::sin(k * 1.3), 4.0 * std::cos(k * 0.7)},
                                .velocity = {4000.0f * std::cos(angle), 4000.0f * std::sin(angle)}});
        (void)*createShape(world, body, k % 2 == 1 ? box({0.4f, 0.2f}) : circle(0.3f));
        for (int i = 0; i < 240; ++i) {
            step(world, JointWorld::kDt);
            ASSERT_TRUE(areSound(world, cloth));
            ASSERT_TRUE(world.quarantinedSoft.empty());
        }
    }
}

/// Adds a body with 40 joints to the ground, more than there are graph colors: the excess is solved serially.
BodyId hold(JointWorld& scene, WorldPosition place) {
    const BodyId body = scene.disc(place);
    for (int i = 0; i < 40; ++i) {
        const WorldPosition pivot = place + Vec2{0.01f * static_cast<float>(i), 0.0f};
        (void)scene.join(scene.define(JointKind::Revolute, scene.ground, body, pivot));
    }
    return body;
}

TEST(Quarantine, doesNotSpreadThroughImmovableBodies) {
    JointWorld scene;
    const BodyId first = hold(scene, {0.0, 0.0}), second = hold(scene, {9.0, 0.0});
    scene.run(0.1f);
    World bad = scene.world;
    bad.bodies.motion[first.index].velocity = {kNoNumber, 0.0f};
    for (int i = 0; i < 10; ++i) {
        step(scene.world, JointWorld::kDt);
        step(bad, JointWorld::kDt);
        EXPECT_EQ(velocityOf(bad, second), velocityOf(scene.world, second)) << i;
        EXPECT_EQ(positionOf(bad, second), positionOf(scene.world, second)) << i;
        EXPECT_TRUE(isFinite(velocityOf(bad, first))) << i;
    }
}

// Regression: restitution against a fast body resulted in up to three times the maximum speed.
TEST(Quarantine, isNotNeededBecauseBodiesStayBelowTheMaximumSpeedAfterAHit) {
    JointWorld scene;
    World& world = scene.world;
    world.settings.gravity = {};
    world.settings.maxSpeed = 40.0f;
    const BodyId wall = *createBody(world, {.kind = BodyKind::Kinematic, .velocity = {36.0f, 0.0f}});
    const BodyId ball =
        *createBody(world, {.position = {1.8, 0.0}, .velocity = {-36.0f, 0.0f}, .bullet = true});
    (void)*createShape(world, wall, box({1.0f, 1.0f}), {.bounciness = 1.0f});
    (void)*createShape(world, ball, circle(0.2f), {.bounciness = 1.0f});
    for (int i = 0; i < 10; ++i) {
        step(world, JointWorld::kDt);
        EXPECT_LE(length(velocityOf(world, ball)), 40.001f) << i;
    }
    EXPECT_NEAR(velocityOf(world, ball).x, 40.0f, 0.01f);
}

}  // namespace
}  // namespace plumb::physics
