#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/play/game_session.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/scene_requests.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

/// A running game in the editor: the player falls; the crate has no body.
class Playing : public EditorFixture {
protected:
    Playing() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            return makeGameSession(project, path, text);
        };
    }
    void play(int frames) {
        hands.key(Key::F5);
        hands.rest(frames);
        ASSERT_TRUE(workspace.play.running());
    }
    [[nodiscard]] Vec2 playedPosition(std::string_view name) {
        const World& world = workspace.play.world();
        return world.get<Transform>(workspace.play.find(named(name))).position;
    }
    [[nodiscard]] const WidgetMap::Widget* widget(std::string_view path) {
        return window.widgets().find(path);
    }
    [[nodiscard]] std::string valueOf(std::string_view path) {
        EXPECT_NE(widget(path), nullptr) << path;
        return widget(path) == nullptr ? std::string{} : widget(path)->value;
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(Playing, aFileThatIsDroppedOntoTheWindowIsRefusedWithTheTrueReason) {
    putFile("outside/step.wav", "RIFF");
    putFile("outside/notes.txt", "");
    play(5);
    const auto drop = [&](std::string_view name) {
        const std::string file = (workspace.project.root / "outside" / name).string();
        window.frame({std::vector<Event>{{.kind = EventKind::FileDropped, .text = file}}});
        return workspace.notice;
    };
    EXPECT_EQ(drop("step.wav"), "Stop the game to add step.wav (F5)");
    EXPECT_EQ(drop("notes.txt"), "notes.txt is not a file type that games can load");
    EXPECT_FALSE(std::filesystem::exists(workspace.project.root / "assets/step.wav"));
    hands.key(Key::F5);
    EXPECT_EQ(drop("step.wav"), "Added assets/step.wav");
}

TEST_F(Playing, theTimelineShowsThePastWithEveryValueInTheInspector) {
    EXPECT_EQ(widget("Timeline/track"), nullptr) << "the game does not run";
    workspace.document.selection.set({named("player")});
    play(120);
    hands.key(Key::F6);
    EXPECT_EQ(valueOf("Timeline/go"), "Go on");
    const std::int64_t newest = workspace.play.ticks();
    const float fallen = playedPosition("player").y;
    const AABB track = widget("Timeline/track")->box;
    // The whole width of the track is 30 s, 1800 ticks.
    const auto at = [&](std::int64_t tick) {
        return Vec2{track.min.x + static_cast<float>(tick) / 1800.0f * track.size().x, track.center().y};
    };
    hands.drag(at(newest), at(30), 6);
    EXPECT_TRUE(workspace.play.paused());
    EXPECT_NEAR(static_cast<double>(workspace.play.ticks()), 30.0, 3.0);
    EXPECT_LT(playedPosition("player").y, fallen - 10.0f);
    EXPECT_EQ(valueOf("Timeline/track"), format("{}", workspace.play.ticks()));
    EXPECT_EQ(valueOf("Inspector/Transform/position.y"), shortestText(playedPosition("player").y));
    EXPECT_EQ(workspace.play.newest(), newest);

    EXPECT_EQ(valueOf("Timeline/go"), "Resume from here");
    EXPECT_EQ(widget("Timeline/track")->box, track) << "it stays under the hand";
    hands.click("Timeline/go");
    EXPECT_FALSE(workspace.play.paused());
    EXPECT_LT(workspace.play.newest(), newest) << "another future";
}

TEST_F(Playing, keysStepBackAndForthAndGoOn) {
    play(60);
    hands.key(Key::F6);
    ASSERT_TRUE(workspace.play.paused());
    const std::int64_t now = workspace.play.ticks();
    const std::uint64_t hash = workspace.play.world().hash();
    for (int i = 0; i < 5; ++i) hands.key(Key::F10, {.shift = true});
    EXPECT_EQ(workspace.play.ticks(), now - 5);
    EXPECT_NE(workspace.play.world().hash(), hash);
    for (int i = 0; i < 5; ++i) hands.key(Key::F10);
    EXPECT_EQ(workspace.play.ticks(), now);
    EXPECT_EQ(workspace.play.world().hash(), hash);
    hands.click("Timeline/back");
    hands.click("Timeline/watch");
    hands.rest(10);
    EXPECT_EQ(workspace.play.ticks(), now);
    EXPECT_TRUE(workspace.play.paused()) << "what was recorded has been watched";
    hands.key(Key::F6);
    hands.rest(5);
    EXPECT_GT(workspace.play.ticks(), now);
}

TEST_F(Playing, theSpeedIsChosenByKeysAndInTheTimeline) {
    play(3);
    EXPECT_EQ(valueOf("Timeline/speed"), "1x");
    for (const char* expected : {"1/2x", "1/4x", "1/8x", "1/8x"}) {
        hands.key(Key::F7);
        EXPECT_EQ(valueOf("Timeline/speed"), expected);
    }
    hands.click("Timeline/speed");
    hands.click("Timeline/speed/8x");
    hands.rest(2);
    EXPECT_EQ(valueOf("Timeline/speed"), "8x");
    const std::int64_t before = workspace.play.ticks();
    hands.rest(10);
    EXPECT_NEAR(static_cast<double>(workspace.play.ticks() - before), 80.0, 1.0);
    hands.key(Key::F9);
    EXPECT_EQ(valueOf("Timeline/speed"), "1x");
}

TEST_F(Playing, aGameIsStartedPausedBeforeItsFirstTick) {
    hands.key(Key::F5, {.shift = true});
    hands.rest(20);
    ASSERT_TRUE(workspace.play.running());
    EXPECT_EQ(workspace.play.ticks(), 0);
    hands.key(Key::F10);
    EXPECT_EQ(workspace.play.ticks(), 1);
}

TEST_F(Playing, escapeNeverStopsTheGame) {
    play(10);
    for (int i = 0; i < 3; ++i) hands.key(Key::Escape);
    hands.click("Timeline/speed");
    hands.key(Key::Escape);
    EXPECT_TRUE(workspace.play.running());
    EXPECT_FALSE(workspace.play.paused());
}

TEST_F(Playing, whatIsChangedWhileItPlaysIsOfferedAndKeptAsOneStep) {
    workspace.document.selection.set({named("crate")});
    const std::string before = workspace.text();
    play(5);
    hands.key(Key::F6);
    hands.enterNumber("Inspector/Transform/position.x", "300");
    hands.enterNumber("Inspector/BoxCollider/width", "40");
    EXPECT_EQ(playedPosition("crate"), (Vec2{300, 64})) << "at once";
    EXPECT_EQ(workspace.text(), before);
    hands.key(Key::F5);
    hands.rest(2);
    ASSERT_EQ(workspace.offeredChanges.size(), 2u);
    EXPECT_EQ(valueOf("Keep/0/value"), "[300, 64]");
    EXPECT_EQ(valueOf("Keep/keep"), "2");
    hands.click("Keep/1");
    EXPECT_EQ(valueOf("Keep/1"), "off");
    hands.click("Keep/keep");
    hands.rest(2);
    EXPECT_EQ(widget("Keep/keep"), nullptr);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{300, 64}));
    EXPECT_EQ(workspace.undo.size(), 1u);
    hands.key(Key::Z, {.control = true});
    EXPECT_EQ(workspace.text(), before);
}

TEST_F(Playing, onlyWhatIsTickedIsKept) {
    workspace.document.selection.set({named("crate")});
    play(5);
    hands.key(Key::F6);
    hands.enterNumber("Inspector/Transform/position.x", "300");
    hands.enterNumber("Inspector/BoxCollider/width", "40");
    hands.key(Key::F5);
    hands.rest(2);
    hands.click("Keep/0");
    hands.rest();
    EXPECT_EQ(valueOf("Keep/keep"), "1");
    hands.click("Keep/keep");
    hands.rest(2);
    EXPECT_EQ(positionOf(named("crate")), (Vec2{200, 64}));
    EXPECT_EQ(workspace.document.world.get<BoxCollider>(workspace.document.find(named("crate"))).width,
              40.0f);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(Playing, nothingIsKeptWhenOneSaysSoOrPressesEscape) {
    workspace.document.selection.set({named("crate")});
    const std::string before = workspace.text();
    for (const bool escape : {false, true}) {
        play(5);
        hands.enterNumber("Inspector/Transform/position.x", "300");
        hands.key(Key::F5);
        hands.rest(2);
        ASSERT_EQ(workspace.offeredChanges.size(), 1u);
        escape ? hands.key(Key::Escape) : hands.click("Keep/nothing");
        hands.rest(2);
        EXPECT_TRUE(workspace.offeredChanges.empty());
        EXPECT_EQ(widget("Keep/keep"), nullptr);
        EXPECT_EQ(workspace.text(), before);
        EXPECT_EQ(workspace.undo.total(), 0u);
    }
}

TEST_F(Playing, whatWasChangedInATimeThatWasRewoundIsOfferedButNotTicked) {
    play(30);
    hands.key(Key::F6);
    const TypeInfo& type = workspace.document.types().of<Transform>();
    workspace.play.edit(named("crate"), type, *type.find("position"), FieldValue::of(Vec2{7, 8}));
    workspace.play.seek(10);
    workspace.play.setPaused(false);
    hands.key(Key::F5);
    hands.rest(2);
    ASSERT_EQ(workspace.offeredChanges.size(), 1u);
    EXPECT_EQ(valueOf("Keep/0"), "off");
    EXPECT_EQ(valueOf("Keep/keep"), "0");
}

TEST_F(Playing, aRestartedLevelUsesTheEditedSceneAndRewindsExactly) {
    const TypeInfo& type = workspace.document.types().of<Transform>();
    std::vector<SetField::Change> change;
    change.push_back({named("crate"), FieldValue::of(Vec2{500, 64})});
    workspace.undo.push(std::make_unique<SetField>(type, *type.find("position"), std::move(change)));
    workspace.startPlaying();
    std::vector<std::uint64_t> hashes{workspace.play.world().hash()};
    for (int tick = 0; tick < 60; ++tick) {
        if (tick == 40) workspace.play.world().resource<SceneRequests>().reload = true;
        workspace.play.step({});
        hashes.push_back(workspace.play.world().hash());
    }
    EXPECT_EQ(playedPosition("crate"), (Vec2{500, 64})) << "not as the file has it";
    EXPECT_LT(playedPosition("player").y, 150.0f) << "it was begun anew";
    // The restart was requested from outside the game, so ticks replayed from an earlier snapshot must not
    // contain the restart.
    for (const std::int64_t tick : {20, 39, 40, 50, 60, 47}) {
        workspace.play.seek(tick);
        EXPECT_EQ(workspace.play.world().hash(), hashes[static_cast<std::size_t>(tick)]) << tick;
    }
}

TEST_F(Playing, textTypedIntoTheRunningGameIsKept) {
    play(5);
    const TypeInfo& type = workspace.document.types().of<Label>();
    const TextId word = workspace.play.world().texts().add("a word that only the game knows");
    workspace.play.edit(named("sign"), type, *type.find("text"), FieldValue::of(word));
    workspace.stopPlaying();
    workspace.keepTicked();
    EXPECT_NE(workspace.text().find("a word that only the game knows"), std::string::npos);
}

TEST_F(Playing, whatTheEngineKeepsOfTheLastTickIsNotShown) {
    workspace.document.selection.set({named("player")});
    play(3);
    ASSERT_NE(widget("Inspector/Transform/position.x"), nullptr);
    EXPECT_EQ(widget("Inspector/Transform/previousPosition.x"), nullptr);
    EXPECT_EQ(widget("Inspector/Transform/previousRotation"), nullptr);
    EXPECT_EQ(widget("Inspector/Transform/previousScale.x"), nullptr);
    EXPECT_NE(widget("Inspector/RigidBody/grounded"), nullptr) << "what the game itself makes of it is";
}

}  // namespace
}  // namespace plumb::editor::ui
