#include <cmath>

#include "core/random.hpp"
#include "physics/model/joints.hpp"
#include "tests/physics/support/effect_worlds.hpp"

// Joints whose bodies were moved apart by a level or a script close again, although that takes energy.

namespace plumb::physics {
namespace {

using namespace test;

BodyId addBob(World& world) {
    ShapeDefinition alone;
    alone.mask = 0;
    return addBody(world, BodyKind::Dynamic, {0.0, 0.25}, box({0.05f, 0.25f}), alone);
}

/// A bob and the ground from which it will hang, in a world with random quality and joint solver.
struct Hung {
    explicit Hung(Random& random) {
        world.settings.quality = static_cast<Quality>(random.below(5));
        world.settings.directJoints = random.below(2) == 0;
        ground = *createBody(world, {.kind = BodyKind::Static});
        bob = addBob(world);
    }
    World world;
    BodyId ground, bob;
};

TEST(OpenedJoints, ofAMovedBodyClose) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random = Random::seeded(seed);
        Hung hung{random};
        auto& [world, ground, bob] = hung;
        const JointKind kind = random.below(2) == 0 ? JointKind::Revolute : JointKind::Weld;
        const JointId joint =
            *createJoint(world, {.kind = kind, .a = ground, .b = bob, .anchorB = {0.0f, -0.25f}});
        run(world, random.below(2) == 0 ? 30 : 120);  // until it is at rest or asleep
        const float shift = random.between(0.1f, 2.0f), angle = random.between(-kPi, kPi);
        ASSERT_TRUE(setPosition(world, bob, {shift * std::cos(angle), shift * std::sin(angle)},
                                random.between(-kPi, kPi))
                        .ok());
        EXPECT_GT(readingOf(world, joint).separation, world.settings.slop);
        run(world, 120);
        // 0.02 m, as the bob still swings, also at quality 0.
        EXPECT_LE(readingOf(world, joint).separation, 0.02f) << seed;
    }
}

TEST(OpenedJoints, closeWhenTheBodyAboveWasMoved) {
    World world;
    const BodyId ground = *createBody(world, {.kind = BodyKind::Static});
    const BodyId bob = addBob(world);
    const JointId joint = *createJoint(world, {.a = ground, .b = bob, .anchorB = {0.0f, -0.25f}});
    run(world, 120);
    ASSERT_FALSE(isAwake(world, bob));
    ASSERT_TRUE(setPosition(world, ground, {1.0, -1.0}, 0.0f).ok());
    run(world, 120);
    EXPECT_LE(readingOf(world, joint).separation, world.settings.slop);
}

TEST(OpenedJoints, returnToTheirLimitsFromOutside) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random = Random::seeded(seed);
        Hung hung{random};
        auto& [world, ground, bob] = hung;
        const float lower = random.between(-1.5f, 1.2f), upper = lower + random.between(0.05f, 0.3f);
        const JointId joint = *createJoint(world, {.a = ground,
                                                   .b = bob,
                                                   .anchorB = {0.0f, -0.25f},
                                                   .limit = {.on = true, .lower = lower, .upper = upper}});
        run(world, 300);
        EXPECT_GE(readingOf(world, joint).value, lower - 0.02f) << seed;
        EXPECT_LE(readingOf(world, joint).value, upper + 0.02f) << seed;
    }
}

TEST(JointRatios, ofZeroAreRejected) {
    World world;
    const BodyId a = addBob(world), b = addBob(world);
    for (const float ratio : {0.0f, -1.0f}) {
        const auto joint = createJoint(world, {.kind = JointKind::Pulley, .a = a, .b = b, .ratio = ratio});
        ASSERT_FALSE(joint.ok());
        EXPECT_EQ(joint.error().where, "JointDefinition.ratio");
    }
}

}  // namespace
}  // namespace plumb::physics
