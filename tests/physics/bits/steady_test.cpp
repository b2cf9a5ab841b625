#include <gtest/gtest.h>

#include "core/task_pool.hpp"
#include "physics/simulation.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/golden_scenes.hpp"
#include "tests/physics/support/joint_world.hpp"
#include "tests/support/allocations.hpp"

// A step that needs no more memory than earlier steps makes no allocations.

namespace plumb::physics {
namespace {

using test::GoldenScene;
using test::goldenScenes;

class SteadyStep : public testing::TestWithParam<std::size_t> {};

/// Runs the same steps twice from a snapshot and returns the number of allocations in the second run, for
/// which all memory exists.
std::size_t allocationsOfTheSecondTime(const GoldenScene& scene, const StepOptions& options) {
    constexpr int kSteps = 60;
    const auto advance = [&](World& world, int i) {
        if (scene.before != nullptr) scene.before(world, i);
        step(world, 1.0f / 60.0f, options);
    };
    World world = scene.build();
    world.settings.sleeping = false;  // falling asleep moves a body between lists, which may allocate
    for (int i = 0; i < 30; ++i) advance(world, i);
    const World saved = world;
    for (int i = 30; i < 30 + kSteps; ++i) advance(world, i);
    world = saved;
    advance(world, 30);  // refills the workspace
    const std::size_t before = plumb::test::allocations().made;
    for (int i = 31; i < 30 + kSteps; ++i) advance(world, i);
    return plumb::test::allocations().made - before;
}

TEST_P(SteadyStep, makesNoAllocations) {
    const GoldenScene& scene = goldenScenes()[GetParam()];
    EXPECT_EQ(allocationsOfTheSecondTime(scene, {}), 0u);
    TaskPool pool{2};
    EXPECT_EQ(allocationsOfTheSecondTime(scene, {.pool = &pool, .minimumWork = 0}), 0u);
}

std::vector<std::size_t> numbers() {
    std::vector<std::size_t> numbers(goldenScenes().size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    return numbers;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SteadyStep, testing::ValuesIn(numbers()),
                         [](const auto& tested) { return std::string{goldenScenes()[tested.param].name}; });

World makeTrees() {
    JointWorld scene;
    Random random = Random::seeded(5);
    for (int i = 0; i < 6; ++i) growTree(scene, random, {20.0 * i, 0.0}, i % 2 == 0);
    return scene.world;
}

TEST(SteadyStep, makesNoAllocationsForJointTrees) {
    World world = makeTrees();
    step(world, 1.0f / 60.0f);
    ASSERT_EQ(world.work.get().joints.trees.trees.size(), 6u);
    const GoldenScene scene{.name = "trees", .build = makeTrees, .steps = 0};
    EXPECT_EQ(allocationsOfTheSecondTime(scene, {}), 0u);
    TaskPool pool{2};
    EXPECT_EQ(allocationsOfTheSecondTime(scene, {.pool = &pool, .minimumWork = 0}), 0u);
}

TEST(State, ofABodyWithABoxIsSmall) {
    World empty, world;
    world.settings.gravity = {};
    constexpr std::size_t kBodies = 1000;
    for (std::size_t i = 0; i < kBodies; ++i) {
        const BodyId body = *createBody(world, {.position = {3.0 * static_cast<double>(i), 0.0}});
        static_cast<void>(createShape(world, body, box({0.5f, 0.5f})));
    }
    step(world, 1.0f / 60.0f);
    ASSERT_TRUE(world.contacts.empty());
    const std::size_t each = (stateBytes(world) - stateBytes(empty)) / kBodies;
    RecordProperty("bytes", static_cast<int>(each));
    EXPECT_LE(each, 256u);  // see engine/physics/README.md, "State and memory"
    EXPECT_GE(each, 200u);  // a lower value would mean that the count is incomplete
}

}  // namespace
}  // namespace plumb::physics
