#include "scene/physics/physics_threads.hpp"

#include <gtest/gtest.h>

#include "physics/simulation.hpp"

namespace plumb {
namespace {

/// Creates a world of separate balls that do not touch.
physics::World ballsOf(int count) {
    physics::World world;
    for (int i = 0; i < count; ++i) {
        const auto body = physics::createBody(world, {.position = {3.0 * (i % 40), 3.0 * (i / 40)}});
        EXPECT_TRUE(body.ok());
        EXPECT_TRUE(physics::createShape(world, *body, physics::circle(0.5f)).ok());
    }
    return world;
}

TEST(PhysicsThreads, areStartedOnlyForLargeWorlds) {
    PhysicsThreads threads{3};
    EXPECT_EQ(threads.of(ballsOf(10)), nullptr);
    TaskPool* pool = threads.of(ballsOf(4200));
    ASSERT_NE(pool, nullptr);
    EXPECT_EQ(pool->threads(), 3);
    EXPECT_EQ(threads.of(ballsOf(10)), nullptr);
    EXPECT_EQ(threads.of(ballsOf(4200)), pool) << "started threads are reused";
}

TEST(PhysicsThreads, oneThreadIsTheCallers) { EXPECT_EQ(PhysicsThreads{1}.of(ballsOf(4200)), nullptr); }

TEST(PhysicsThreads, areAsManyAsTheMachineHasByDefault) {
    PhysicsThreads threads;
    EXPECT_GE(threads.threads(), 1);
    EXPECT_LE(threads.threads(), 8);
    threads.setThreads(5);
    EXPECT_EQ(threads.threads(), 5);
}

}  // namespace
}  // namespace plumb
