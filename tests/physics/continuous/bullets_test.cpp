#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/task_pool.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

/// Balls without walls, on average one per cell of 9 m2, in an area proportional to their number.
World makeFlight(int balls, int bullets, std::uint64_t seed) {
    World world;
    world.settings.gravity = {};
    Random random = Random::seeded(seed);
    constexpr float kCell = 3.0f;  // m
    const float half = 0.5f * kCell * std::sqrt(static_cast<float>(balls + bullets));
    const auto add = [&](float radius, float speed, bool bullet) {
        BodyDefinition definition;
        definition.position = {random.between(-half, half), random.between(-half, half)};
        definition.velocity = rotate(rotFromAngle(random.between(-3.14f, 3.14f)), {speed, 0.0f});
        definition.bullet = bullet;
        static_cast<void>(createShape(world, *createBody(world, definition), circle(radius)));
    };
    for (int i = 0; i < balls; ++i) add(0.2f, 30.0f, false);
    for (int i = 0; i < bullets; ++i) add(0.05f, 300.0f, true);
    return world;
}

std::uint32_t sweptPairs(int balls, int bullets) {
    World world = makeFlight(balls, bullets, 7);
    step(world, kTick);
    return detectionOf(world).swept;
}

}  // namespace

// A bullet of 300 m/s sweeps an area of 5 m x 0.5 m per step. With one body per 9 m2, 1 to 3 bodies are near
// its path; a pair of bullets may be found twice, once for each. So 6 tests per bullet are enough, while a
// search without spatial index would test each bullet against all bodies.
TEST(Bullets, areTestedOnlyAgainstBodiesNearTheirPath) {
    for (const auto& [balls, bullets] : {std::array{2000, 50}, {2000, 400}, {0, 800}, {8000, 100}}) {
        EXPECT_LE(sweptPairs(balls, bullets), static_cast<std::uint32_t>(6 * bullets))
            << bullets << " among " << balls;
        EXPECT_GT(sweptPairs(balls, bullets), 0u);
    }
}

TEST(Bullets, areTestedEquallyOftenWithAnyNumberOfThreads) {
    World one = makeFlight(500, 100, 3);
    World several = one;
    TaskPool pool{3};
    for (int i = 0; i < 10; ++i) {
        step(one, kTick);
        step(several, kTick, {.pool = &pool, .minimumWork = 0});
        EXPECT_EQ(detectionOf(one).swept, detectionOf(several).swept);
        EXPECT_EQ(hashOf(one), hashOf(several));
    }
}

TEST(Bullets, passOnlyBodiesThatTheyDoNotCollideWith) {
    enum class Wall { Plain, Trigger, OtherLayer, OtherMask, SameGroup, Joined, Filtered, Count };
    for (int kind = 0; kind < static_cast<int>(Wall::Count); ++kind) {
        for (const bool moves : {false, true}) {
            const auto wall = static_cast<Wall>(kind);
            SCOPED_TRACE(testing::Message() << kind << ' ' << moves);
            World world;
            world.settings.gravity = {};
            const BodyId shot = *createBody(world, {.velocity = {600.0f, 0.0f}, .bullet = true});
            ShapeDefinition own{.group = wall == Wall::SameGroup ? -3 : 0}, theirs = own;
            theirs.isTrigger = wall == Wall::Trigger;
            if (wall == Wall::OtherLayer) own.mask = 2;
            if (wall == Wall::OtherMask) theirs.mask = 2;
            static_cast<void>(createShape(world, shot, circle(0.1f), own));
            const BodyId target = *createBody(
                world, {.kind = moves ? BodyKind::Dynamic : BodyKind::Static, .position = {5.0, 0.0}});
            static_cast<void>(createShape(world, target, box({0.05f, 3.0f}), theirs));
            if (moves) static_cast<void>(setMass(world, target, 1.0e6f));
            if (wall == Wall::Joined) {
                ASSERT_TRUE(createJoint(world, {.kind = JointKind::Filter, .a = target, .b = shot}).ok());
            }
            StepOptions options;
            if (wall == Wall::Filtered)
                options.hooks.filter = [](void*, const World&, ShapeId, ShapeId) { return false; };
            for (int i = 0; i < 2; ++i) step(world, kTick, options);
            if (wall == Wall::Plain) {
                EXPECT_LT(centreOf(world, shot).x, 5.0);
            } else {
                EXPECT_NEAR(centreOf(world, shot).x, 20.0, 1.0e-3);
                EXPECT_EQ(velocityOf(world, target), Vec2{});
            }
        }
    }
}

}  // namespace plumb::physics
