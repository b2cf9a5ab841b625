#include "physics/workspace.hpp"
#include "tests/accuracy/experiments.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

/// An experiment and a quality at which it reaches all its goals; a regression fails the test.
struct ReachedGoal {
    std::string_view scene;
    Quality quality;
};

constexpr ReachedGoal kPromises[] = {
    {"pendulum", 2}, {"chain100", 2},  {"chain1000", 2},    {"freefall", 2},  {"projectile", 2},
    {"bounces", 2},  {"incline", 2},   {"rolling", 2},      {"cradle", 2},    {"oblique", 2},
    {"recovery", 2}, {"stack15", 2},   {"stack50", 2},      {"cardhouse", 2}, {"farpyramid", 2},
    {"stack100", 3}, {"arch", 3},      {"heavytops", 3},    {"stack20", 4},   {"heavyonten", 4},
    {"heavy100", 5}, {"heavy1000", 5}, {"ballandchain", 3}, {"bridge160", 5},
};

TEST(Accuracy, reachedGoalsAreNotLost) {
    for (const ReachedGoal& promise : kPromises) {
        SCOPED_TRACE(promise.scene);
        bool found = false;
        for (const accuracy::Experiment& experiment : accuracy::allExperiments()) {
            if (experiment.name != promise.scene) continue;
            found = true;
            accuracy::Trial trial{promise.quality, experiment.gravity};
            experiment.run(trial);
            ASSERT_FALSE(trial.findings().empty());
            for (const accuracy::Finding& finding : trial.findings()) {
                EXPECT_LE(finding.error, finding.target) << finding.name << " in " << finding.unit;
            }
        }
        EXPECT_TRUE(found);
    }
}

TEST(Accuracy, automaticQualityGivesMoreSubstepsOnlyToHardIslands) {
    Playground scene;
    scene.world.settings.automaticQuality = true;
    scene.floor();
    scene.crate({-20.0, 0.5});
    scene.crate({0.0, 0.5});
    const BodyId heavy = scene.crate({0.0, 1.5});
    ASSERT_TRUE(setMass(scene.world, heavy, 25.0f).ok());
    scene.run(3);
    ASSERT_EQ(scene.world.work.get().groups.size(), 2u);
    EXPECT_EQ(scene.world.work.get().groups[0].substeps, 4);
    EXPECT_EQ(scene.world.work.get().groups[0].bodies, 1);
    EXPECT_EQ(scene.world.work.get().groups[1].substeps, 8);
    EXPECT_EQ(scene.world.work.get().groups[1].bodies, 2);
}

TEST(Accuracy, automaticQualityMakesAHighStackStandHigher) {
    double lost[2];
    for (const bool automatic : {false, true}) {
        Playground scene;
        scene.world.settings.automaticQuality = automatic;
        scene.floor();
        BodyId top;
        for (int i = 0; i < 40; ++i) top = scene.crate({0.0, 0.5 + i});
        scene.run(600);
        lost[automatic ? 1 : 0] = 39.5 - scene.y(top);
    }
    EXPECT_LT(lost[1], 0.5 * lost[0]);
    EXPECT_GT(lost[1], 0.0);
}

}  // namespace
}  // namespace plumb::physics
