#include <bit>

#include <gtest/gtest.h>

#include "core/hash.hpp"
#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::scenes {
namespace {

std::uint64_t hashAfter(const Scene& scene, int steps, int threads) {
    const auto world =
        plumbEngine().open({.gravity = scene.gravity, .sleeping = scene.sleeping, .threads = threads});
    const BeforeStep before = scene.build(*world, scene.size);
    world->finish();
    for (int step = 0; step < steps; ++step) {
        if (before) before(*world, step);
        world->step(kStep);
    }
    EXPECT_EQ(world->missing(), "");
    Hasher hasher;
    for (std::uint32_t i = 0; i < world->bodies().size(); ++i) {
        if (!world->alive({i})) continue;
        const Pose pose = world->poseOf({i});
        for (const double number : {pose.x, pose.y, pose.cos, pose.sin})
            hasher.add(std::bit_cast<std::uint64_t>(number));
    }
    return hasher.value();
}

class Determinism : public testing::TestWithParam<const char*> {};

// Large scenes with everything that could depend on threads: islands that merge and fall asleep, joints, and
// bodies that are added and removed.
TEST_P(Determinism, aSceneHasTheSameBitsWithAnyNumberOfThreads) {
    constexpr int kSteps = 40;
    const Scene* scene = findScene(GetParam());
    ASSERT_NE(scene, nullptr);

    const std::uint64_t alone = hashAfter(*scene, kSteps, 1);

    EXPECT_EQ(hashAfter(*scene, kSteps, 1), alone);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(hashAfter(*scene, kSteps, threads), alone) << threads;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism,
                         testing::Values("joint_grid", "large_pyramid", "rain", "smash", "spinner", "tumbler",
                                         "washer", "junkyard", "compounds", "pile5000"),
                         [](const auto& scene) { return std::string{scene.param}; });

}  // namespace
}  // namespace plumb::scenes
