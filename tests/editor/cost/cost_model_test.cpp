#include "editor/model/cost/body_errors.hpp"
#include "editor/model/cost/island_table.hpp"
#include "editor/model/cost/stage_times.hpp"
#include "physics/simulation.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/editor/support/cost_scenes.hpp"

namespace plumb::editor {
namespace {

Profiler::Sample sampleOf(std::vector<float> zones, float drawing) {
    Profiler::Sample sample;
    sample.zones = std::move(zones);
    for (const float time : sample.zones) sample.milliseconds += time;
    sample.drawing = drawing;
    return sample;
}

TEST(StageTimes, showMedianAndMaximumOfTheLastSecondInTheOrderOfTheStep) {
    const std::vector<Profiler::Zone> zones{{"patrol"}, {"solve", true}, {"physics"}, {"broad phase", true},
                                            {"camera"}, {"idle"}};
    std::deque<Profiler::Sample> samples;
    samples.push_back(sampleOf({90.0f, 90.0f, 90.0f, 90.0f, 90.0f}, 90.0f));  // older than one second
    for (int i = 0; i < 60; ++i)
        samples.push_back(sampleOf({1.0f, static_cast<float>(i), 100.0f, 0.5f, 2.0f, 0.0f}, 3.0f));
    const std::vector<StageTime> times = stageTimes(samples, zones);
    std::vector<std::string_view> names;
    for (const StageTime& time : times) names.push_back(time.name);
    EXPECT_EQ(names, (std::vector<std::string_view>{"broad phase", "solve", "camera", "patrol", "picture"}));
    EXPECT_FLOAT_EQ(times[1].median, 30.0f);
    EXPECT_FLOAT_EQ(times[1].p99, 59.0f);
    EXPECT_FLOAT_EQ(times.back().median, 3.0f);
    EXPECT_NE(times[1].doc, "");
    EXPECT_GT(tickTime(samples).median, 100.0f);
}

using IslandTable = CostFixture;

TEST_F(IslandTable, eachHeapIsARowWithItsShareOfTheStepTime) {
    open(CostScene{}.stack(6, 100.0f).stack(2, 400.0f));
    play(10);
    std::vector<IslandRow> rows = islandRows(workspace.play.world(), 90.0f);
    ASSERT_EQ(rows.size(), 2u);
    sortIslands(rows, IslandColumn::Bodies, true);
    EXPECT_EQ(rows[0].report.bodies, 6u);
    EXPECT_EQ(rows[1].report.bodies, 2u);
    EXPECT_GT(rows[0].microseconds, 2.0f * rows[1].microseconds);
    EXPECT_NEAR(rows[0].microseconds + rows[1].microseconds, 90.0f, 0.01f);
    sortIslands(rows, IslandColumn::Cost, false);
    EXPECT_EQ(rows[0].report.bodies, 2u);
    const std::vector<EntityId> entities = entitiesOfIsland(workspace.play.world(), rows[0].report.first);
    ASSERT_EQ(entities.size(), 2u);
    for (const EntityId entity : entities) EXPECT_TRUE(workspace.play.idOf(entity));
}

TEST_F(IslandTable, sleepingBodiesAreNoIsland) {
    open(CostScene{}.stack(1));
    play(120);
    EXPECT_TRUE(islandRows(workspace.play.world(), 90.0f).empty());
}

using BodyErrors = CostFixture;

TEST_F(BodyErrors, theLowestBoxOfAStackHasTheDeepestOverlapAndTheLargestForce) {
    open(CostScene{R"("quality": 0, "sleeping": false)"}.stack(8));
    play(120);
    const physics::World& world = workspace.play.world().findResource<PhysicsState>()->world;
    const std::vector<float> errors = bodyErrors(world);
    float most = 0.0f;
    for (std::uint32_t body = 0; body < errors.size(); ++body) {
        if (world.bodies.info[body].kind != physics::BodyKind::Dynamic) {
            EXPECT_EQ(errors[body], 0.0f);
        }
        most = std::max(most, errors[body]);
    }
    const auto errorOf = [&](std::string_view name) {
        return errors[workspace.play.world()
                          .findResource<PhysicsState>()
                          ->bodyOf[workspace.play.find(named(name)).index] -
                      1];
    };
    EXPECT_GT(errorOf("box 0"), 0.0f);
    EXPECT_EQ(errorOf("box 0"), most);
    EXPECT_LT(errorOf("box 7"), errorOf("box 0"));
    // Eight boxes of 1 kg rest on two contact points of the lowest box: four weights on each.
    float lowest = 0.0f;
    for (const ContactPush& push : contactPushes(world)) lowest = std::max(lowest, push.weights);
    EXPECT_NEAR(lowest, 4.0f, 0.8f);
}

}  // namespace
}  // namespace plumb::editor
