#include "editor/model/cost/advice.hpp"

#include <algorithm>

#include "tests/editor/support/cost_scenes.hpp"

namespace plumb::editor {
namespace {

/// Tests each advice rule with a scene to which it applies and with one to which it does not.
class AdviceTest : public CostFixture {
protected:
    const Advice* judged(const CostScene& scene, std::string_view rule, int ticks = 200) {
        if (workspace.play.running()) workspace.stopPlaying();
        open(scene);
        play(ticks);
        measure();
        EXPECT_TRUE(whatIf.result().complete) << whatIf.refusal();
        return adviceOf(rule);
    }
    static CostScene springs(const std::string& physics) {
        CostScene scene{physics};
        for (int i = 0; i < 60; ++i) {
            scene.add(
                format("planet {}", i),
                format(
                    R"("Transform": {"position": [{}, -300]}, "CircleCollider": {"radius": 4, "isTrigger": true}, )"
                    R"("RigidBody": {"gravityScale": 0, "velocity": [0, 40]})",
                    i * 20));
        }
        scene.add("sun", R"("Transform": {"position": [600, -900]}, )"
                         R"("Attractor": {"acceleration": 200, "distance": 200, "linear": true})");
        return scene;
    }
};

TEST_F(AdviceTest, ruleNamesAreUnique) {
    const auto rules = adviceRules();
    for (std::size_t i = 0; i < rules.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(rules[i].name, rules[j].name);
    }
    EXPECT_GE(rules.size(), 10u);
}

TEST_F(AdviceTest, aSinkingStackIsAdvisedTheQualityThatHoldsIt) {
    const Advice* advice = judged(CostScene{R"("quality": 0)"}.stack(12), "too coarse");
    ASSERT_NE(advice, nullptr);
    EXPECT_EQ(advice->words.find("Bodies overlap by up to "), 0u) << advice->words;
    EXPECT_EQ(advice->remedy.field, "quality");
    EXPECT_EQ(judged(CostScene{R"("quality": 6)"}.stack(3), "too coarse"), nullptr);
}

TEST_F(AdviceTest, lowerQualityIsAdvisedForAFewCrates) {
    const Advice* advice =
        judged(CostScene{R"("quality": 6)"}.stack(4).stack(4, 200).stack(4, 300), "too fine");
    ASSERT_NE(advice, nullptr);
    EXPECT_NE(advice->words.find("saves"), std::string::npos) << advice->words;
    EXPECT_EQ(judged(CostScene{R"("quality": 0)"}.stack(4), "too fine"), nullptr);
}

TEST_F(AdviceTest, automaticQualityIsAdvisedForAFewHardHeapsAmongManyEasyOnes) {
    // The costs are set here, not measured: their differences are smaller than a test machine's timing noise.
    WhatIfResult result;
    result.complete = true;
    result.settings.quality = 1;
    for (int quality = 0; quality <= 6; ++quality) {
        WhatIfPoint point{WhatIfKind::Quality, quality};
        point.microseconds = 100.0f * static_cast<float>(1 << quality);
        point.overlap = 0.1f / static_cast<float>(1 << (2 * quality));
        result.points.push_back(point);
    }
    WhatIfPoint automatic{WhatIfKind::Automatic, 1};
    automatic.microseconds = 250.0f;
    automatic.overlap = result.points[3].overlap;
    result.points.push_back(automatic);
    const PhysicsTape tape;
    const auto says = [&] {
        const std::vector<Advice> all = adviceFor({result, tape});
        return std::any_of(all.begin(), all.end(),
                           [](const Advice& one) { return one.rule == "automatic quality"; });
    };
    EXPECT_TRUE(says());
    result.points.back().microseconds = 900.0f;
    EXPECT_FALSE(says()) << "quality 3 for all is cheaper";
    result.points.back().microseconds = 250.0f;
    result.points.back().overlap = result.points[1].overlap;
    EXPECT_FALSE(says()) << "it helps nothing";
}

TEST_F(AdviceTest, slowBulletsAreReported) {
    CostScene scene;
    scene.box("a", {100, 280}, R"("bullet": true)").box("b", {200, 280}, R"("bullet": true)");
    scene.box("c", {300, 280});
    const Advice* advice = judged(scene, "bullets");
    ASSERT_NE(advice, nullptr);
    EXPECT_EQ(advice->words.find("2 bodies use CCD"), 0u) << advice->words;
    EXPECT_EQ(advice->remedy.objects.size(), 2u);
    CostScene fast;
    fast.box("shot", {100, 0}, R"("bullet": true, "velocity": [3000, 0])");
    EXPECT_EQ(judged(fast, "bullets"), nullptr);
}

TEST_F(AdviceTest, fastBodiesWithoutContinuousDetectionAreReported) {
    const auto shot = [](const std::string& physics, const std::string& speed) {
        CostScene scene{physics};
        return scene.box("shot", {100, -3000}, format(R"("velocity": [{}, 0])", speed));
    };
    const Advice* advice = judged(shot(R"("continuous": false)", "4000"), "fast without CCD");
    ASSERT_NE(advice, nullptr);
    EXPECT_EQ(advice->remedy.field, "continuous");
    EXPECT_EQ(advice->about.size(), 1u);
    EXPECT_EQ(judged(shot(R"("continuous": true)", "4000"), "fast without CCD"), nullptr);
    EXPECT_EQ(judged(shot(R"("continuous": false)", "40"), "fast without CCD", 60), nullptr);
}

TEST_F(AdviceTest, restingBodiesAreCountedIfSleepingIsOff) {
    const Advice* advice = judged(CostScene{R"("sleeping": false)"}.stack(1).stack(1, 200), "sleep");
    ASSERT_NE(advice, nullptr);
    EXPECT_EQ(advice->words.find("2 bodies could sleep"), 0u) << advice->words;
    EXPECT_EQ(judged(CostScene{}.stack(2), "sleep"), nullptr);
}

TEST_F(AdviceTest, rungeKuttaForSlowSpringsIsNoBetterThanVerlet) {
    // The positions of the bodies are measured. The costs are set here: on a busy machine a cost
    // ratio of 1.3 may be measured as 1.
    const auto says = [&](std::string_view integrator) {
        judged(springs(format(R"("integrator": "{}", "quality": 4)", integrator)), "Runge-Kutta");
        WhatIfResult result = whatIf.result();
        for (WhatIfPoint& point : result.points)
            point.microseconds = point.kind == WhatIfKind::Quality ? 130.0f : 100.0f;
        std::vector<Advice> all = adviceFor({result, *whatIf.tape()});
        std::erase_if(all, [](const Advice& one) { return one.rule != "Runge-Kutta"; });
        return all;
    };
    const std::vector<Advice> advice = says("Rk4");
    ASSERT_EQ(advice.size(), 1u);
    EXPECT_EQ(advice.front().remedy.field, "integrator");
    EXPECT_TRUE(says("Verlet").empty());
}

TEST_F(AdviceTest, explicitEulerIsReported) {
    const Advice* advice =
        judged(springs(R"("integrator": "ExplicitEuler", "quality": 0)"), "explicit Euler");
    ASSERT_NE(advice, nullptr);
    EXPECT_EQ(judged(springs(R"("integrator": "SemiImplicitEuler", "quality": 0)"), "explicit Euler"),
              nullptr);
}

TEST_F(AdviceTest, iterationsWithoutBenefitAreReported) {
    const Advice* advice = judged(CostScene{R"("iterations": 16)"}.stack(6).stack(6, 200), "iterations");
    ASSERT_NE(advice, nullptr);
    EXPECT_EQ(judged(CostScene{}.stack(6), "iterations"), nullptr);
}

TEST_F(AdviceTest, manyEventsOfPersistentContactsAreCounted) {
    CostScene scene{R"("sleeping": false)"};
    for (int i = 0; i < 60; ++i) scene.stack(2, 100.0f + 40.0f * static_cast<float>(i));
    const Advice* advice = judged(scene, "stay events", 60);
    ASSERT_NE(advice, nullptr);
    EXPECT_TRUE(advice->remedy.label.empty()) << "it is set in code";
    EXPECT_EQ(judged(CostScene{}.stack(2), "stay events"), nullptr);
}

TEST_F(AdviceTest, aRemedyIsOneUndoStepAndChangesNothingElse) {
    open(CostScene{}.stack(3));
    const std::string before = workspace.text();
    ScenePhysics present;
    present.gravity = {0.0f, 300.0f};
    applyRemedy(workspace, qualityRemedy(5), present);
    ASSERT_NE(scenePhysics(workspace.document.world), nullptr);
    EXPECT_EQ(scenePhysics(workspace.document.world)->quality, 5);
    EXPECT_EQ(scenePhysics(workspace.document.world)->gravity, (Vec2{0.0f, 300.0f}))
        << "as the project has it";
    EXPECT_TRUE(workspace.document.world.has<ScenePhysics>(workspace.document.find(named("camera"))));
    applyRemedy(workspace, qualityRemedy(4), present);
    EXPECT_EQ(workspace.undo.size(), 2u);
    workspace.undo.undo();
    EXPECT_EQ(scenePhysics(workspace.document.world)->quality, 5);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
}

TEST_F(AdviceTest, aRemedyInTheGameIsOfferedForKeepingEvenIfTheSceneHasNoSettings) {
    open(CostScene{}.stack(3));
    const std::string before = workspace.text();
    play(40);
    applyRemedy(workspace, qualityRemedy(5), ScenePhysics{});
    ASSERT_NE(scenePhysics(workspace.play.world()), nullptr);
    EXPECT_EQ(scenePhysics(workspace.play.world())->quality, 5);
    EXPECT_EQ(scenePhysics(workspace.document.world), nullptr);
    workspace.play.seek(20);
    EXPECT_EQ(scenePhysics(workspace.play.world()), nullptr) << "it was not there yet";
    workspace.play.seek(40);
    EXPECT_EQ(scenePhysics(workspace.play.world())->quality, 5) << "and comes again";
    workspace.stopPlaying();
    ASSERT_EQ(workspace.offeredChanges.size(), 1u);
    EXPECT_EQ(workspace.offeredChanges[0].field, "ScenePhysics.quality");
    EXPECT_EQ(workspace.text(), before);
    workspace.keepTicked();
    ASSERT_NE(scenePhysics(workspace.document.world), nullptr);
    EXPECT_EQ(scenePhysics(workspace.document.world)->quality, 5);
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), before);
}

}  // namespace
}  // namespace plumb::editor
