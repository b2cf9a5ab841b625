#include "physics/islands/island_report.hpp"

#include "physics/measure/measures.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

TEST(IslandReport, countsBodiesContactsAndJointsOfEachIsland) {
    Playground scene;
    scene.floor();
    const BodyId low = scene.crate({0.0, 0.5}), high = scene.crate({0.0, 1.5});
    const BodyId alone = scene.ball({20.0, 5.0});
    const BodyId hung = scene.ball({30.0, 10.0}), below = scene.ball({30.0, 8.0});
    const BodyId hook = scene.body(BodyKind::Static, {30.0, 12.0});
    const auto tie = [&](BodyId a, BodyId b) {
        EXPECT_TRUE(createJoint(scene.world, {.a = a, .b = b, .anchorA = {0.0f, -2.0f}}).ok());
    };
    tie(hook, hung);
    tie(hung, below);
    scene.run(3);
    const std::vector<IslandReport> islands = reportIslands(scene.world);
    ASSERT_EQ(islands.size(), 3u);
    EXPECT_EQ(islands[0].first, low);
    EXPECT_EQ(islands[0].bodies, 2u);
    EXPECT_EQ(islands[0].contacts, 2u);
    EXPECT_EQ(islands[0].joints, 0u);
    EXPECT_EQ(islands[0].quality, 2);
    EXPECT_GT(islands[0].overlap, 0.0f);
    EXPECT_LT(islands[0].overlap, 0.01f);
    EXPECT_EQ(islands[1].first, alone);
    EXPECT_EQ(islands[1].contacts, 0u);
    EXPECT_NEAR(islands[1].speed, 0.5f, 0.01f);
    EXPECT_EQ(islands[2].bodies, 2u);
    EXPECT_EQ(islands[2].joints, 2u);
    EXPECT_EQ(islandIndices(scene.world)[high.index], 0u);
    EXPECT_EQ(islandIndices(scene.world)[below.index], 2u);
    EXPECT_EQ(islandIndices(scene.world)[hook.index], kNone);
    EXPECT_EQ(islandIndices(scene.world)[hung.index], 2u);
}

TEST(IslandReport, reportsTheQualityOfTheLastStep) {
    Playground scene;
    scene.floor();
    scene.crate({0.0, 0.5});
    const BodyId fine = *createBody(scene.world, {.position = {20.0, 0.5}, .quality = 5});
    scene.shape(fine, box({0.5f, 0.5f}));
    EXPECT_EQ(reportIslands(scene.world)[1].quality, 5) << "before the first step";
    scene.run(1);
    const World copy = scene.world;
    for (const World* world : std::array<const World*, 2>{&scene.world, &copy}) {
        const std::vector<IslandReport> islands = reportIslands(*world);
        ASSERT_EQ(islands.size(), 2u);
        EXPECT_EQ(islands[0].quality, 2);
        EXPECT_EQ(islands[1].quality, 5);
    }
}

TEST(IslandReport, reportsTheQualityOfTheWorldForNewBodies) {
    Playground scene;
    const BodyId sleeper = scene.sleeper();
    const BodyId fine = *createBody(scene.world, {.position = {20.0, 0.5}, .canSleep = false, .quality = 5});
    scene.shape(fine, box({0.5f, 0.5f}));
    scene.run(1);
    setAwake(scene.world, sleeper, true);
    scene.crate({40.0, 0.5});
    const std::vector<IslandReport> islands = reportIslands(scene.world);
    ASSERT_EQ(islands.size(), 3u);
    EXPECT_EQ(islands[0].quality, 2) << "the default, as the island was asleep in the last step";
    EXPECT_EQ(islands[1].quality, 5);
    EXPECT_EQ(islands[2].quality, 2) << "the default, as the crate is new";
}

TEST(IslandReport, reportsTheOwnQualityOfTheFirstBodyToo) {
    Playground scene;
    scene.world.settings.automaticQuality = true;
    scene.floor();
    scene.crate({0.0, 0.5});
    scene.crate({0.0, 1.5}, {0.5f, 0.5f}, {.density = 20.0f});
    EXPECT_EQ(reportIslands(scene.world).at(0).quality, 2) << "the default before the first step";
    scene.run(2);
    ASSERT_EQ(reportIslands(scene.world).size(), 1u);
    EXPECT_EQ(reportIslands(scene.world)[0].quality, 3);
}

TEST(IslandReport, omitsSleepingBodiesAndChangesNothing) {
    Playground scene;
    const BodyId sleeper = scene.sleeper();
    EXPECT_TRUE(reportIslands(scene.world).empty());
    EXPECT_EQ(islandIndices(scene.world)[sleeper.index], kNone);
    World pit = makePit(60, 3);
    for (int i = 0; i < 200; ++i) step(pit, kTick);
    const std::uint64_t before = hashOf(pit);
    EXPECT_FALSE(reportIslands(pit).empty());
    EXPECT_EQ(hashOf(pit), before);
}

TEST(IslandReport, reportsTheSeparationOfJoints) {
    struct Case {
        JointDefinition joint;
        float expected;  // m
    };
    const Case cases[] = {
        {{.kind = JointKind::Revolute, .anchorA = {2.1f, 0.0f}}, 0.1f},
        {{.kind = JointKind::Revolute, .anchorA = {2.1f, 0.0f}, .hertz = 5.0f}, 0.0f},
        {{.kind = JointKind::Weld, .anchorA = {1.0f, 0.0f}, .anchorB = {-1.0f, 0.0f}, .referenceAngle = 0.1f},
         0.1f},
        {{.kind = JointKind::Distance, .length = 1.5f}, 0.5f},
        {{.kind = JointKind::Distance, .length = 1.5f, .limit = {true, 1.0f, 1.9f}}, 0.1f},
        {{.kind = JointKind::Distance, .spring = {true, 2.0f, 0.1f, 1.0f}}, 0.0f},
        {{.kind = JointKind::Prismatic, .anchorA = {0.0f, 0.2f}, .axis = {1.0f, 0.0f}}, 0.2f},
        {{.kind = JointKind::Wheel, .anchorA = {0.0f, 0.2f}, .axis = {0.0f, 1.0f}}, 2.0f},
    };
    for (const Case& one : cases) {
        Playground scene;
        const BodyId a = scene.ball({0.0, 0.0}, 0.2f), b = scene.ball({2.0, 0.0}, 0.2f);
        JointDefinition definition = one.joint;
        definition.a = a;
        definition.b = b;
        const Result<JointId> made = createJoint(scene.world, definition);
        ASSERT_TRUE(made.ok());
        EXPECT_NEAR(openingOf(scene.world, made->index), one.expected, 1e-5f)
            << static_cast<int>(definition.kind);
    }
}

}  // namespace
}  // namespace plumb::physics
