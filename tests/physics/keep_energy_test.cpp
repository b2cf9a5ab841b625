#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "physics/workspace.hpp"
#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

/// Two joined discs of 1 m, `apart` m from each other, that rotate about their common center.
struct Pair {
    JointWorld& scene;
    BodyId a, b;
    JointId joint;

    Pair(JointWorld& world, WorldPosition middle, float apart) : scene{world} {
        a = scene.disc(middle + Vec2{-0.5f * apart, 0.0f});
        b = scene.disc(middle + Vec2{0.5f * apart, 0.0f});
        joint = scene.join(scene.define(JointKind::Revolute, a, b, middle));
    }
};

float fastestOf(const JointWorld& scene, BodyId body) {
    const float reach = scene.world.bodies.info[body.index].reach;
    return length(velocityOf(scene.world, body)) + reach * std::fabs(angularVelocityOf(scene.world, body));
}

TEST(JointLanes, closeOpenedJointsWithinTheSpeedLimit) {
    for (const JointKind kind : {JointKind::Revolute, JointKind::Weld}) {
        SCOPED_TRACE(static_cast<int>(kind));
        JointWorld scene;
        scene.world.settings.gravity = {};
        scene.world.settings.directJoints = false;
        scene.world.settings.quality = 4;
        const BodyId a = scene.disc({0.0, 0.0}), b = scene.disc({3.0, 2.0});
        JointDefinition definition = scene.define(kind, a, b, {1.0, 0.0});
        definition.anchorB = {-1.0f, 0.0f};
        const JointId joint = scene.join(definition);
        const float most = 10.0f * scene.world.settings.pushSpeed;
        const float open = length(scene.gapOf(joint));
        EXPECT_GT(open, 1.0f);
        for (int i = 0; i < 120; ++i) {
            const Vec2 before = scene.place(b) - scene.place(a);
            scene.run(JointWorld::kDt);
            const Vec2 way = (scene.place(b) - scene.place(a)) - before;
            ASSERT_LT(length(way) / JointWorld::kDt, 1.5f * most) << i;
            ASSERT_LT(fastestOf(scene, a), most) << i;
        }
        EXPECT_LT(length(scene.gapOf(joint)), 0.01f * open);
    }
}

// Shortening a rope does work on the system; the angular momentum L = m r^2 w is conserved.
TEST(KeepEnergy, keepsTheWorkOfShorteningARope) {
    for (const bool direct : {true, false}) {
        for (const bool held : {true, false}) {
            SCOPED_TRACE(testing::Message() << direct << held);
            JointWorld scene;
            scene.world.settings.gravity = {};
            scene.world.settings.directJoints = direct;
            const BodyId ball = scene.disc({2.0, 0.0});
            const BodyId other = held ? scene.ground : scene.disc({-2.0, 0.0});
            JointDefinition rope = scene.define(JointKind::Distance, other, ball, {});
            rope.anchorA = rope.anchorB = {};
            rope.length = held ? 2.0f : 4.0f;
            ASSERT_EQ(scene.place(scene.ground), WorldPosition{});
            const JointId joint = scene.join(rope);
            ASSERT_TRUE(setVelocity(scene.world, ball, {0.0f, 2.0f}).ok());
            if (!held) {
                ASSERT_TRUE(setVelocity(scene.world, other, {0.0f, -2.0f}).ok());
            }
            for (int i = 0; i < 120; ++i) {
                rope.length *= 0.99424f;  // halves the length in two seconds
                ASSERT_TRUE(setDefinition(scene.world, joint, rope).ok());
                scene.run(JointWorld::kDt);
            }
            const Vec2 arm = toVec2(scene.place(ball));
            EXPECT_NEAR(length(arm), 1.0f, 0.01f);
            EXPECT_NEAR(cross(arm, velocityOf(scene.world, ball)), 4.0f, 0.04f);
        }
    }
}

TEST(KeepEnergy, tracksEnergyOnlyOfIslandsWithJoints) {
    JointWorld scene;
    const BodyId loose = scene.disc({5.0, 0.0});
    scene.run(0.5f);
    EXPECT_TRUE(scene.world.bodies.energies.empty());
    const Pair pair{scene, {0.0, 0.0}, 2.0f};
    scene.run(0.5f);
    EXPECT_EQ(scene.world.bodies.energies[loose.index].peak, 0.0f);
    // Both discs of 1 kg fall at 5 m/s.
    EXPECT_NEAR(scene.world.bodies.energies[pair.a.index].peak, 12.5f, 0.2f);
    EXPECT_EQ(scene.world.bodies.energies[pair.a.index].peak, scene.world.bodies.energies[pair.b.index].peak);
}

/// Maximum relative energy gain of planks that are thrown at a wall; no forces act on them.
double mostGainOfThrown(std::uint64_t seed, int& met) {
    Random random = Random::seeded(seed);
    World world;
    world.settings.gravity = {};
    world.settings.sleeping = false;
    world.settings.quality = static_cast<Quality>(random.below(4));
    const auto wall = *createBody(world, {.kind = BodyKind::Static});
    (void)*createShape(world, wall, box({0.5f, 50.0f}), {.friction = random.unit(), .bounciness = 1.0f});
    const float thin = 0.02f + 0.2f * random.unit();
    const auto plank =
        *createBody(world, {.position = {2.0, 0.0},
                            .angle = 6.0f * random.unit(),
                            .velocity = {-5.0f - 50.0f * random.unit(), 40.0f * random.unit() - 20.0f},
                            .angularVelocity = 200.0f * random.unit() - 100.0f});
    (void)*createShape(world, plank, box({0.4f, thin}),
                       {.friction = random.unit(), .bounciness = random.unit()});
    const auto energy = [&] {
        const BodyMass& mass = world.bodies.mass[plank.index];
        const BodyMotion& motion = world.bodies.motion[plank.index];
        return static_cast<double>(mass.mass * lengthSquared(motion.velocity) +
                                   mass.inertia * motion.angularVelocity * motion.angularVelocity);
    };
    const double start = energy();
    double most = start;
    for (int i = 0; i < 30; ++i) {
        step(world, JointWorld::kDt);
        most = std::max(most, energy());
    }
    met += energy() != start ? 1 : 0;
    return most / start - 1.0;
}

TEST(KeepEnergy, contactsAddNoEnergy) {
    int met = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) EXPECT_LE(mostGainOfThrown(seed, met), 0.002) << seed;
    EXPECT_GT(met, 1500);
}

TEST(KeepEnergy, isCheckedInIslandsWithoutJointsOnlyAfterAnImpact) {
    JointWorld scene;
    const auto floor = *createBody(scene.world, {.kind = BodyKind::Static, .position = {0.0, -1.0}});
    (void)*createShape(scene.world, floor, box({50.0f, 1.0f}), {});
    const auto crate = *createBody(scene.world, {.position = {0.0, 0.5}});
    (void)*createShape(scene.world, crate, box({0.5f, 0.5f}), {});
    for (int i = 0; i < 60; ++i) {
        scene.run(JointWorld::kDt);
        EXPECT_TRUE(scene.world.work.get().gainers.empty()) << i;
    }
    const auto other = *createBody(scene.world, {.position = {-2.0, 0.5}, .velocity = {20.0f, 0.0f}});
    (void)*createShape(scene.world, other, box({0.5f, 0.5f}), {});
    bool gained = false;
    for (int i = 0; i < 20; ++i) {
        scene.run(JointWorld::kDt);
        for (const std::uint32_t body : scene.world.work.get().gainers) gained |= body == crate.index;
    }
    EXPECT_TRUE(gained) << "the crate gains energy from the other body";
    EXPECT_GT(velocityOf(scene.world, crate).x, 5.0f) << "the crate keeps the gained energy";
}

TEST(KeepEnergy, lostEnergyMayReturnForALimitedTime) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const Pair pair{scene, {0.0, 0.0}, 2.0f};
    for (const BodyId body : {pair.a, pair.b}) {
        ASSERT_TRUE(setDrag(scene.world, body, 1.0f, 0.0f).ok());
        ASSERT_TRUE(setVelocity(scene.world, body, {10.0f, 0.0f}).ok());
    }
    scene.run(1.0f);
    const float lost = scene.world.bodies.energies[pair.a.index].credit;
    EXPECT_GT(lost, 10.0f);  // J; the initial energy is 50 J
    EXPECT_LT(lost, 50.0f);
    scene.run(10.0f);
    EXPECT_LT(scene.world.bodies.energies[pair.a.index].credit, 1.0f);
}

TEST(KeepEnergy, allowsEnergyFromForcesMotorsAndEdits) {
    JointWorld scene;
    scene.world.settings.gravity = {};
    const Pair pushed{scene, {0.0, 0.0}, 2.0f};
    for (int i = 0; i < 60; ++i) {
        for (const BodyId body : {pushed.a, pushed.b})
            ASSERT_TRUE(applyForce(scene.world, body, {7.0f, 0.0f}).ok());
        scene.run(JointWorld::kDt);
    }
    EXPECT_NEAR(velocityOf(scene.world, pushed.b).x, 7.0f, 0.01f);

    const BodyId wheel = scene.disc({0.0, 20.0});
    JointDefinition motor = scene.define(JointKind::Revolute, scene.ground, wheel, {0.0, 20.0});
    motor.motor = {.on = true, .speed = 30.0f, .maxForce = 1000.0f};
    scene.join(motor);
    scene.run(0.5f);
    EXPECT_NEAR(angularVelocityOf(scene.world, wheel), 30.0f, 0.1f);
}

}  // namespace
}  // namespace plumb::physics
