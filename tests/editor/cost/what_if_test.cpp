#include "editor/model/cost/what_if.hpp"

#include "editor/model/cost/cost_words.hpp"
#include "physics/simulation.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/editor/support/cost_scenes.hpp"
#include "tests/editor/support/played_games.hpp"

namespace plumb::editor {
namespace {

using WhatIfTest = CostFixture;

const PhysicsState& bodiesOf(const World& world) { return *world.findResource<PhysicsState>(); }

/// Replays the recorded physics inputs with the same step as the game.
physics::World playedAgain(const PhysicsTape& tape) {
    physics::World world = tape.starts.front().world;
    for (std::size_t tick = tape.starts.front().tick; tick < tape.ticks.size(); ++tick) {
        applyInput(world, tape.ticks[tick]);
        physics::step(world, 1.0f / 60.0f);
    }
    return world;
}

void expectSamePlaces(const physics::World& again, const physics::World& game, const PhysicsTape& tape) {
    ASSERT_FALSE(tape.watched.empty());
    for (const WatchedBody& watched : tape.watched) {
        ASSERT_EQ(alive(again, watched.body), alive(game, watched.body)) << watched.body.index;
        if (!alive(game, watched.body)) continue;
        EXPECT_EQ(again.bodies.pose[watched.body.index], game.bodies.pose[watched.body.index])
            << watched.body.index;
    }
}

TEST_F(WhatIfTest, replayingTheTapeReproducesTheGame) {
    open(CostScene{}.stack(8).box("thrown", {300, 100}, R"("velocity": [-400, -100])"));
    play(200);
    measure();
    ASSERT_NE(whatIf.tape(), nullptr);
    EXPECT_EQ(whatIf.tape()->ticks.size(), 200u);
    EXPECT_GT(whatIf.tape()->contacts, 0u);
    expectSamePlaces(playedAgain(*whatIf.tape()), bodiesOf(workspace.play.world()).world, *whatIf.tape());
}

TEST_F(WhatIfTest, editsOfBodiesByTheGameAreReplayed) {
    CostScene scene;
    scene.stack(2, 220.0f).box("on the lift", {430, 240});
    scene.add("lift", R"("Transform": {"position": [400, 280]}, "KinematicBody": {"velocity": [15, -5]}, )"
                      R"("BoxCollider": {"width": 96, "height": 16})");
    open(scene);
    play(100);
    const TypeInfo& body = workspace.document.types().of<RigidBody>();
    const TypeInfo& place = workspace.document.types().of<Transform>();
    for (int tick = 0; tick < 200; ++tick) {
        if (tick == 40)
            workspace.play.edit(named("box 1"), body, *body.find("velocity"),
                                FieldValue::of(Vec2{150, -200}));
        if (tick == 90)
            workspace.play.edit(named("on the lift"), place, *place.find("position"),
                                FieldValue::of(Vec2{300, 50}));
        workspace.play.step({});
    }
    measure();
    ASSERT_NE(whatIf.tape(), nullptr) << whatIf.refusal();
    EXPECT_EQ(whatIf.tape()->ticks.size(), 300u);
    EXPECT_EQ(whatIf.tape()->leftOut, 0u);
    std::size_t inputs = 0;
    for (const TickInput& input : whatIf.tape()->ticks) inputs += input.bodies.size();
    EXPECT_GE(inputs, 2u);
    EXPECT_GT(whatIf.tape()->contacts, 0u);
    expectSamePlaces(playedAgain(*whatIf.tape()), bodiesOf(workspace.play.world()).world, *whatIf.tape());
}

TEST_F(WhatIfTest, measuringDoesNotChangeTheGame) {
    open(CostScene{}.stack(6));
    play(90);
    for (int tick = 0; tick < 60; ++tick) workspace.play.step({});
    const std::uint64_t alone = workspace.play.world().hash();
    workspace.stopPlaying();
    play(90);
    whatIf.begin(workspace);
    for (int tick = 0; tick < 60; ++tick) {
        whatIf.update(workspace);
        workspace.play.step({});
    }
    whatIf.wait();
    ASSERT_TRUE(whatIf.measured());
    EXPECT_GT(whatIf.tape()->contacts, 0u);
    EXPECT_EQ(workspace.play.world().hash(), alone);
}

TEST_F(WhatIfTest, higherQualityCostsMoreAndHasSmallerErrors) {
    open(CostScene{}.stack(12));
    play(180);
    measure();
    const WhatIfResult result = whatIf.result();
    ASSERT_TRUE(result.complete);
    EXPECT_EQ(result.bodies, 12u);
    EXPECT_FALSE(result.isChaotic) << result.hair;
    ASSERT_NE(result.present(), nullptr);
    EXPECT_EQ(result.present()->quality, 2);
    const WhatIfPoint* coarse = result.find(WhatIfKind::Quality, 0);
    const WhatIfPoint* fine = result.find(WhatIfKind::Quality, 6);
    ASSERT_NE(coarse, nullptr);
    ASSERT_NE(fine, nullptr);
    EXPECT_GT(coarse->error(), 4.0f * fine->error());
    EXPECT_LT(coarse->microseconds * 2.0f, fine->microseconds);
    EXPECT_GT(coarse->away, fine->away);
    EXPECT_GE(fine->away, 0.0f);
    for (const WhatIfPoint& point : result.points)
        RecordProperty(format("{}/{}", static_cast<int>(point.kind), point.quality),
                       format("{} us, {} m, away {}", point.microseconds, point.error(), point.away));
}

TEST_F(WhatIfTest, withoutARunningGameTheStartOfTheSceneIsMeasured) {
    open(CostScene{}.stack(5));
    const std::string before = workspace.text();
    measure();
    ASSERT_TRUE(whatIf.result().complete) << whatIf.refusal();
    EXPECT_FALSE(whatIf.wasPlaying());
    EXPECT_EQ(whatIf.result().ticksOnTape, 300);
    EXPECT_EQ(workspace.text(), before);
    EXPECT_FALSE(workspace.play.running());
}

TEST_F(WhatIfTest, scenesThatCannotBeMeasuredAreReported) {
    open(CostScene{}.stack(3));
    play(5);
    measure();
    EXPECT_FALSE(whatIf.measured());
    EXPECT_NE(whatIf.refusal().find("half a second"), std::string::npos) << whatIf.refusal();
    workspace.stopPlaying();
    open(CostScene{});
    measure();
    EXPECT_NE(whatIf.refusal().find("This scene has no dynamic bodies"), std::string::npos)
        << whatIf.refusal();
}

TEST_F(WhatIfTest, stoppingTheGameCancelsTheMeasurement) {
    open(CostScene{}.stack(3));
    play(100);
    whatIf.begin(workspace);
    ASSERT_TRUE(whatIf.busy());
    workspace.stopPlaying();
    whatIf.update(workspace);
    EXPECT_FALSE(whatIf.busy());
    EXPECT_NE(whatIf.refusal(), "");
}

TEST_F(WhatIfTest, fiveHundredBodiesAreMeasuredWithinTheTimeLimit) {
    workspace.makeSession = [](const std::string&, const std::string&) { return playgroundSession(); };
    play(310);
    measure();
    const WhatIfResult result = whatIf.result();
    ASSERT_TRUE(result.complete) << whatIf.refusal();
    EXPECT_EQ(result.bodies, 500u);
    EXPECT_GT(whatIf.tape()->contacts, 500u);
    EXPECT_GE(result.ticks, WhatIf::kMinTicks);
    EXPECT_GT(result.find(WhatIfKind::Quality, 0)->error(), result.find(WhatIfKind::Quality, 6)->error());
}

TEST_F(WhatIfTest, measuringCanBeStopped) {
    open(CostScene{}.stack(40));
    play(320);
    whatIf.begin(workspace);
    while (!whatIf.measured() && whatIf.busy()) whatIf.update(workspace);
    whatIf.cancel();
    EXPECT_FALSE(whatIf.busy());
}

TEST_F(WhatIfTest, manyCollidingBallsAreReportedAsChaotic) {
    CostScene scene;
    const auto wall = [&](const char* at, const char* size) {
        scene.add("wall", format(R"("Transform": {"position": [{}]}, "BoxCollider": {{}})", at, size));
    };
    wall("60, -60", R"("width": 32, "height": 400)");
    wall("340, -60", R"("width": 32, "height": 400)");
    wall("60, -60", R"("width": 320, "height": 32)");
    for (int i = 0; i < 40; ++i)
        scene.add(format("ball {}", i),
                  format(R"("Transform": {"position": [{}, {}]}, "CircleCollider": {"radius": 10}, )"
                         R"("RigidBody": {"bounciness": 0.95, "gravityScale": 0, "velocity": [{}, {}]})",
                         100 + i % 8 * 26, i / 8 * 26, i % 2 == 0 ? 300 : -300, i % 3 * 200 - 200));
    open(scene);
    play(290);
    measure();
    ASSERT_TRUE(whatIf.result().complete);
    EXPECT_TRUE(whatIf.result().isChaotic) << whatIf.result().hair;
    EXPECT_LT(whatIf.result().present()->away, 0.0f) << "it would mean nothing";
}

TEST_F(WhatIfTest, resultsAreSummarizedInWords) {
    WhatIfResult result;
    result.settings.quality = 3;
    for (int quality = 0; quality <= 6; ++quality) {
        WhatIfPoint point{WhatIfKind::Quality, quality};
        point.microseconds = 100.0f + 320.0f * static_cast<float>(quality == 4 ? 2 : quality == 3 ? 1 : 0);
        point.overlap = quality < 3 ? 0.05f : quality == 3 ? 0.012f : 0.0016f;
        result.points.push_back(point);
    }
    result.complete = true;
    EXPECT_EQ(qualityWords(result, result.points[3], nullptr),
              "Quality 3: 0.42 ms, largest error 12 mm (0.8 px).");
    EXPECT_EQ(qualityWords(result, result.points[4], &result.points[3]),
              "Quality 4: +0.32 ms, error 1.6 mm (0.1 px).");
    EXPECT_EQ(enoughQuality(result)->quality, 4);
    EXPECT_EQ(
        verdictWords(result),
        "Current quality 3: 0.42 ms per tick, largest error 12 mm (0.8 px), which may be visible. Quality 4 "
        "costs 0.32 ms more, error 1.6 mm (0.1 px).");
}

}  // namespace
}  // namespace plumb::editor
