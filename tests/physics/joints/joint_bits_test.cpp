#include <gtest/gtest.h>

#include "core/cpu.hpp"
#include "core/random.hpp"
#include "core/task_pool.hpp"
#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

/// Builds a net of discs connected by random revolute, distance, prismatic, weld and wheel joints.
void weave(JointWorld& scene, std::uint64_t seed) {
    Random random = Random::seeded(seed);
    constexpr int kSide = 8;
    std::vector<BodyId> net;
    for (int i = 0; i < kSide * kSide; ++i) {
        net.push_back(scene.disc({1.0 * (i % kSide), -1.0 * (i / kSide)}, 0.5f + 2.0f * random.unit()));
    }
    const auto tie = [&](BodyId a, BodyId b) {
        const Vec2 middle = 0.5f * (scene.place(a) + scene.place(b));
        constexpr JointKind kKinds[] = {JointKind::Revolute, JointKind::Distance, JointKind::Prismatic,
                                        JointKind::Weld,     JointKind::Wheel,    JointKind::Revolute};
        JointDefinition definition = scene.define(kKinds[random.below(6)], a, b, middle);
        definition.length = 0.5f;
        if (definition.kind == JointKind::Distance) definition.anchorA = definition.anchorB = {};
        definition.limit = {random.below(2) == 0, -0.3f, 0.6f};
        definition.motor = {random.below(3) == 0, 1.0f, 5.0f};
        definition.spring = {random.below(2) == 0, 4.0f, 0.5f};
        (void)scene.join(definition);
    };
    tie(scene.ground, net[0]);
    tie(net[kSide - 1], scene.ground);
    for (int i = 0; i < kSide * kSide; ++i) {
        if (i % kSide != 0) tie(net[static_cast<std::size_t>(i) - 1], net[static_cast<std::size_t>(i)]);
        if (i >= kSide) tie(net[static_cast<std::size_t>(i - kSide)], net[static_cast<std::size_t>(i)]);
    }
}

std::uint64_t hashAfter(std::uint64_t seed, SimdWidth width, int threads) {
    JointWorld scene;
    weave(scene, seed);
    const SimdWidth usual = simdWidth();
    TaskPool pool{threads};
    if (threads > 1) scene.options = {.pool = &pool, .minimumWork = 0};
    (void)setSimdWidth(width);
    scene.run(1.0f);
    (void)setSimdWidth(usual);
    for (const BodyPose& pose : scene.world.bodies.pose) EXPECT_TRUE(std::isfinite(pose.centre.x));
    return hashOf(scene.world);
}

TEST(Joints, giveTheSameBitsForEachInstructionSetAndAnyNumberOfThreads) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        const std::uint64_t hash = hashAfter(seed, SimdWidth::Scalar, 1);
        for (const SimdWidth width : {SimdWidth::Sse2, SimdWidth::Avx2, SimdWidth::Neon}) {
            if (!hasSimdWidth(width)) continue;
            EXPECT_EQ(hash, hashAfter(seed, width, 1));
            EXPECT_EQ(hash, hashAfter(seed, width, 3));
        }
    }
}

TEST(Joints, continueFromASnapshotWithTheSameBits) {
    JointWorld scene;
    weave(scene, 7);
    scene.run(0.5f);
    const World saved = scene.world;
    scene.run(0.5f);
    const std::uint64_t hash = hashOf(scene.world);

    scene.world = saved;
    scene.run(0.5f);

    EXPECT_EQ(hashOf(scene.world), hash);
}

TEST(Joints, fallAsleepWithTheirBodiesAndMayBeDestroyedThere) {
    JointWorld scene;
    scene.world.settings.sleeping = true;
    const BodyId top = scene.disc({0.0, -1.0}), low = scene.disc({0.0, -2.0});
    (void)scene.join(scene.define(JointKind::Revolute, scene.ground, top, {0.0, -0.5}));
    const JointId lower = scene.join(scene.define(JointKind::Revolute, top, low, {0.0, -1.5}));
    scene.run(3.0f);
    ASSERT_FALSE(isAwake(scene.world, low));
    ASSERT_TRUE(scene.world.joints.awake.empty());

    destroyJoint(scene.world, lower);
    scene.run(1.0f);

    EXPECT_LT(scene.place(low).y, -4.0f);
    EXPECT_NEAR(scene.place(top).y, -1.0f, 0.01f);
}

TEST(Joints, wakeTogether) {
    JointWorld scene;
    scene.world.settings.sleeping = true;
    BodyId last = scene.ground;
    for (int i = 0; i < 5; ++i) {
        const BodyId next = scene.disc({0.0, -1.0 - i});
        (void)scene.join(scene.define(JointKind::Revolute, last, next, {0.0, -0.5 - i}));
        last = next;
    }
    scene.run(5.0f);
    ASSERT_FALSE(isAwake(scene.world, last));

    (void)*applyImpulse(scene.world, last, {5.0f, 0.0f});

    EXPECT_EQ(scene.world.joints.awake.size(), 5u);
    scene.run(0.1f);
    EXPECT_GT(scene.place(last).x, 0.1f);
}

TEST(Joints, ofOneBodyMayExceedTheNumberOfGraphColours) {
    JointWorld scene;
    const BodyId hub = scene.disc({0.0, 0.0}, 10.0f);
    for (int i = 0; i < 40; ++i) {
        const BodyId leaf = scene.disc({0.0, -1.0}, 0.1f);
        (void)scene.join(scene.define(JointKind::Revolute, hub, leaf, {0.0, -0.5}));
    }
    const JointId pin = scene.join(scene.define(JointKind::Revolute, scene.ground, hub, {0.0, 0.0}));

    scene.run(5.0f);

    EXPECT_NEAR(jointForce(scene.world, pin).y, 14.0f * JointWorld::kGravity, 1.4f);
    EXPECT_LT(length(scene.gapOf(pin)), 0.01f);
}

TEST(Joints, rejectInvalidDefinitions) {
    JointWorld scene;
    const BodyId body = scene.disc({0.0, 0.0});
    JointDefinition definition = scene.define(JointKind::Revolute, scene.ground, body, {0.0, 0.0});
    definition.anchorA.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(createJoint(scene.world, definition).ok());
    definition = scene.define(JointKind::Revolute, body, body, {0.0, 0.0});
    EXPECT_FALSE(createJoint(scene.world, definition).ok());
    definition = scene.define(JointKind::Revolute, scene.ground, body, {0.0, 0.0});
    definition.limit = {true, 1.0f, -1.0f};
    EXPECT_FALSE(createJoint(scene.world, definition).ok());
    destroyJoint(scene.world, JointId{});
    EXPECT_EQ(jointForce(scene.world, JointId{}), Vec2{});
}

}  // namespace
}  // namespace plumb::physics
