#include <gtest/gtest.h>

#include "core/task_pool.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

TEST(DetectionCounts, everyPairIsCountedOnceAsRejectedOrTouching) {
    World world = makePit(120, 7);
    TaskPool pool{3};
    DetectionCounts all;
    for (int i = 0; i < 300; ++i) {
        step(world, kTick, {.pool = i % 2 == 0 ? &pool : nullptr, .minimumWork = 0});
        const DetectionCounts counts = detectionOf(world);
        ASSERT_EQ(counts.pairs,
                  counts.apartByBounds + counts.apartByCircles + counts.apartByAxes + counts.touching);
        ASSERT_LE(counts.recycled, counts.touching);
        all += counts;
    }
    for (const std::uint32_t count :
         {all.apartByBounds, all.apartByCircles, all.apartByAxes, all.touching, all.recycled})
        EXPECT_GT(count, 100u);
}

TEST(DetectionCounts, ofOnePairNameTheTestThatRejectedIt) {
    const auto countsOf = [](WorldPosition place, float angle) {
        Playground scene;
        scene.world.settings.gravity = {};
        scene.crate({0.0, 0.0});
        scene.shape(scene.body(BodyKind::Dynamic, place, angle), box({0.5f, 0.5f}));
        scene.run(1);
        return detectionOf(scene.world);
    };
    EXPECT_EQ(countsOf({9.0, 0.0}, 0.0f).pairs, 0u);
    EXPECT_EQ(countsOf({1.0, 0.0}, 0.0f).touching, 1u);
    EXPECT_EQ(countsOf({1.06, 0.0}, 0.0f).apartByAxes, 1u);  // the bounding circles overlap at the corners
    const DetectionCounts apart = countsOf({1.06, 1.06}, 0.0f);
    EXPECT_EQ(apart.pairs, 1u);
    EXPECT_EQ(apart.apartByCircles, 1u);
}

TEST(DetectionCounts, areZeroAtRestAndInACopy) {
    Playground scene;
    scene.floor();
    scene.crate({0.0, 0.5});
    scene.run(10);
    EXPECT_EQ(detectionOf(scene.world).touching, 1u);
    World copied = scene.world;
    EXPECT_EQ(detectionOf(copied).pairs, 0u);
    scene.world.settings.sleeping = true;
    scene.run(120);
    ASSERT_TRUE(scene.world.awake.empty());
    EXPECT_EQ(detectionOf(scene.world).pairs, 0u);
}

}  // namespace
}  // namespace plumb::physics
