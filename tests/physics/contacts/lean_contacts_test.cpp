#include <algorithm>
#include <cmath>

#include "core/cpu.hpp"
#include "core/random.hpp"
#include "core/task_pool.hpp"
#include "physics/debug_draw.hpp"
#include "physics/narrowphase/axis_aligned_boxes.hpp"
#include "physics/narrowphase/collide.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Contacts without rotation or friction have kernels of their own, and axis-aligned boxes have a narrow phase
// of their own. Both are fast paths that omit terms which are zero, so the results must be equal bit for bit.

namespace plumb::physics {
namespace {

constexpr int kSeeds = 60;

Vec2 anyHalf(Random& random) { return {random.between(0.2f, 0.6f), random.between(0.2f, 0.6f)}; }

/// Builds a pit in which bodies with fixed rotation fall on a kinematic bar that moves and may rotate. Some
/// bodies have drag, a locked x axis or joints. @param rubs  true: with friction
World makeUprightPit(std::uint64_t seed, bool rubs) {
    Random random = Random::seeded(seed);
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    const auto add = [&](const BodyDefinition& body, const Geometry& outline) {
        ShapeDefinition shape;
        shape.density = random.between(0.5f, 3.0f);
        shape.friction = rubs ? random.between(0.0f, 1.0f) : 0.0f;
        if (rubs && random.below(8) == 0) shape.surfaceSpeed = random.between(-2.0f, 2.0f);
        const BodyId made = *createBody(world, body);
        EXPECT_TRUE(createShape(world, made, outline, shape).ok());
        return made;
    };
    add({.kind = BodyKind::Static, .position = {0.0, -1.0}}, box({8.0f, 1.0f}));
    for (const double side : {-7.0, 7.0})
        add({.kind = BodyKind::Static, .position = {side, 5.0}, .angle = random.between(-0.2f, 0.2f)},
            box({0.5f, 8.0f}));
    const bool turning = random.below(2) == 0, tied = seed % 5 == 0;  // tied: with joints, so full contacts
    add({.kind = BodyKind::Kinematic,
         .position = {-2.0, 1.0},
         .velocity = {random.between(0.0f, 0.5f), 0.0f},
         .angularVelocity = turning ? random.between(-1.0f, 1.0f) : 0.0f},
        box({1.5f, 0.2f}));
    BodyId last;
    for (int i = 0; i < 40; ++i) {
        BodyDefinition body{.position = {-5.0 + 1.2 * (i % 9), 2.0 + 1.25 * (i / 9)}, .fixedRotation = true};
        body.position.x += random.between(-0.1f, 0.1f);
        body.angle = random.below(4) == 0 ? random.between(-1.0f, 1.0f) : 0.0f;
        body.linearDrag = random.below(6) == 0 ? 1.0f : 0.0f;
        body.lockX = random.below(20) == 0;
        const bool round = random.below(3) == 0;
        const BodyId made = add(body, round ? circle(random.between(0.2f, 0.5f)) : box(anyHalf(random)));
        if (tied && last && random.below(10) == 0) {
            EXPECT_TRUE(createJoint(world, {.a = last, .b = made, .anchorA = {1.2f, 0.0f}}).ok());
        }
        last = made;
    }
    return world;
}

TEST(LeanContacts, moveBodiesLikeFullContactsBitForBit) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const bool rubs = seed % 2 == 0;
        World lean = makeUprightPit(seed, rubs), full = makeUprightPit(seed, rubs);
        full.manifest.pinnedOn |= Manifest::bit(Effect::Rotation) | Manifest::bit(Effect::Friction);
        for (int i = 0; i < 150; ++i) {
            step(lean, kTick);
            step(full, kTick);
            ASSERT_EQ(bitsOf(lean), bitsOf(full)) << "after step " << i;
        }
        EXPECT_GT(touching(lean), 20);
        EXPECT_EQ(runsOf(lean, Effect::Rotation), 0u);
        EXPECT_EQ(runsOf(lean, Effect::Friction), rubs ? 150u : 0u);
        EXPECT_EQ(runsOf(full, Effect::Rotation), 150u);
        ASSERT_EQ(lean.contacts.size(), full.contacts.size());
        for (std::size_t i = 0; i < lean.contacts.size(); ++i) {
            EXPECT_EQ(lean.contacts[i].impulse0, full.contacts[i].impulse0);
            EXPECT_EQ(lean.contacts[i].frictionImpulse, full.contacts[i].frictionImpulse);
        }
    }
}

/// Adds bodies that can rotate: balls on a floor of their own, a pendulum, and in some pits a body that falls
/// onto those with fixed rotation, so that both kinds share an island for a while.
void addRotating(World& world, std::uint64_t seed) {
    Random random = Random::seeded(seed ^ 77u);
    const BodyId floor = *createBody(world, {.kind = BodyKind::Static, .position = {40.0, -1.0}});
    EXPECT_TRUE(createShape(world, floor, box({8.0f, 1.0f})).ok());
    ShapeDefinition lively;
    lively.bounciness = seed % 2 == 0 ? 0.5f : 0.0f;
    lively.rollingResistance = seed % 3 == 0 ? 0.05f : 0.0f;
    for (int i = 0; i < 6; ++i) {
        const BodyId ball = *createBody(world, {.position = {36.0 + i, 1.0 + random.between(0.0f, 2.0f)}});
        EXPECT_TRUE(createShape(world, ball, circle(0.3f), lively).ok());
    }
    const BodyId bob = *createBody(world, {.position = {46.0, 5.0}});
    EXPECT_TRUE(createShape(world, bob, circle(0.3f)).ok());
    EXPECT_TRUE(
        createJoint(world, {.a = floor, .b = bob, .anchorA = {5.0f, 6.0f}, .anchorB = {-1.0f, 0.0f}}).ok());
    if (seed % 3 != 0) return;
    const BodyId plank = *createBody(world, {.position = {0.0, 9.0}, .angle = 0.3f});
    EXPECT_TRUE(createShape(world, plank, box({0.8f, 0.1f}), lively).ok());
}

TEST(LeanContacts, areUsedInIslandsWithFixedRotationNextToOthers) {
    int apart = 0, together = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        World lean = makeUprightPit(seed, seed % 2 == 0);
        if (seed % 4 == 0) lean.settings.automaticQuality = true;
        if (seed % 4 == 1) lean.settings.tolerance = 0.002f;
        addRotating(lean, seed);
        World full = lean;
        full.manifest.pinnedOn |= Manifest::bit(Effect::Rotation);
        for (int i = 0; i < 150; ++i) {
            step(lean, kTick);
            step(full, kTick);
            ASSERT_EQ(bitsOf(lean), bitsOf(full)) << "after step " << i;
            const std::vector<SolveGroup>& groups = lastStepOf(lean)->groups;
            const bool hasLean = std::any_of(groups.begin(), groups.end(),
                                             [](const SolveGroup& group) { return group.withoutRotation; });
            (hasLean ? apart : together) += 1;
            if (i == 70) lean = World{lean};  // a copy has no cached data, which must not matter
        }
        ASSERT_EQ(lean.contacts.size(), full.contacts.size());
    }
    EXPECT_GT(apart, kSeeds * 50);
    EXPECT_GT(together, kSeeds);
}

std::vector<std::uint64_t> bitsAfter(std::uint64_t seed, const StepOptions& options = {}) {
    World world = makeUprightPit(seed, seed % 2 == 0);
    for (int i = 0; i < 150; ++i) step(world, kTick, options);
    return bitsOf(world);
}

TEST(LeanContacts, haveTheSameBitsForAnyThreadsAndInstructionSet) {
    const SimdWidth widest = simdWidth();
    TaskPool pool{3};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<std::uint64_t> expected = bitsAfter(seed);
        EXPECT_EQ(bitsAfter(seed, {.pool = &pool, .minimumWork = 0}), expected);
        for (const SimdWidth width : {SimdWidth::Scalar, SimdWidth::Sse2, SimdWidth::Avx2, SimdWidth::Neon}) {
            if (!setSimdWidth(width)) continue;
            EXPECT_EQ(bitsAfter(seed), expected) << static_cast<int>(width);
        }
        setSimdWidth(widest);
    }
}

TEST(LeanContacts, ofUprightBoxesEqualTheDeepestPointOfFullContacts) {
    constexpr float kSpeculative = 0.02f;
    int met = 0, corners = 0;
    for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const Vec2 halfA = anyHalf(random), halfB = anyHalf(random);
        Vec2 way{random.between(-1.3f, 1.3f), random.between(-1.3f, 1.3f)};
        if (seed % 3 == 0) way.x = std::copysign(halfA.x + halfB.x + random.between(-0.01f, 0.025f), way.x);
        if (seed % 4 == 0) way.y = std::copysign(halfA.y + halfB.y + random.between(-0.01f, 0.025f), way.y);
        const Manifold lean = collideUpright(halfA, halfB, way, kSpeculative);
        const Manifold full = collide(box(halfA), box(halfB), {}, {way, {}}, kSpeculative);
        ASSERT_EQ(lean.count > 0, full.count > 0);
        if (lean.count == 0) continue;
        ++met;
        corners += lean.normal.x * lean.normal.y != 0.0f ? 1 : 0;
        const ManifoldPoint& first = full.points[0];
        const ManifoldPoint& last = full.points[full.count - 1];
        EXPECT_NEAR(lean.points[0].separation, std::min(first.separation, last.separation), 1e-6f);
        EXPECT_NEAR(lean.normal.x, full.normal.x, 1e-4f);
        EXPECT_NEAR(lean.normal.y, full.normal.y, 1e-4f);
        EXPECT_NEAR(lean.points[0].point.x, 0.5f * (first.point.x + last.point.x), 1e-5f);
        EXPECT_NEAR(lean.points[0].point.y, 0.5f * (first.point.y + last.point.y), 1e-5f);
    }
    EXPECT_GT(met, 5000);
    EXPECT_GT(corners, 20);
}

TEST(LeanContacts, areReplacedAsSoonAsABodyCanRotateAndUsedAgainAfterwards) {
    World world = makeUprightPit(2, true);
    for (int i = 0; i < 60; ++i) step(world, kTick);
    const BodyId wheel = *createBody(world, {.position = {0.0, 30.0}});
    ASSERT_TRUE(createShape(world, wheel, circle(0.5f)).ok());
    for (int i = 0; i < 60; ++i) step(world, kTick);
    EXPECT_EQ(runsOf(world, Effect::Rotation), 60u);
    setFixedRotation(world, wheel, true);
    for (int i = 0; i < 60; ++i) step(world, kTick);
    EXPECT_EQ(runsOf(world, Effect::Rotation), 60u);
}

TEST(LeanContacts, areRecomputedIfABoxIsRotatedByAnEdit) {
    Playground play;
    play.floor();
    BodyDefinition body{.position = {0.0, 0.5}, .fixedRotation = true};
    const BodyId crate = *createBody(play.world, body);
    play.shape(crate, box({0.5f, 0.5f}));
    play.run(60);
    ASSERT_NE(play.world.contacts.at(0).flags & kAlongAxes, 0);
    ASSERT_TRUE(setPosition(play.world, crate, {0.0, 1.0}, kPi / 4.0f).ok());
    play.run(120);
    EXPECT_EQ(play.world.contacts.at(0).flags & kAlongAxes, 0);
    EXPECT_NEAR(play.y(crate), std::sqrt(0.5), 0.006);  // it rests on its corner
    ASSERT_TRUE(setPosition(play.world, crate, {0.0, 1.0}, 0.0f).ok());
    play.run(120);
    EXPECT_NE(play.world.contacts.at(0).flags & kAlongAxes, 0);
    EXPECT_NEAR(play.y(crate), 0.5, 0.006);
}

}  // namespace
}  // namespace plumb::physics
