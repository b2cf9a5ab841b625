#include "app/effect_rows.hpp"
#include "editor/model/effects/effects_view.hpp"
#include "editor/model/play/game_session.hpp"
#include "gameplay/components/music.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

class EffectsPanelTest : public EditorFixture {
protected:
    EffectsPanelTest()
        : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            return makeGameSession(project, path, text);
        };
        hands.click("Tab/Effects");
        hands.rest(2);
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) {
        hands.rest(2);
        const auto* found = window.widgets().find(widget);
        return found == nullptr ? "(none)" : found->value;
    }
    void playTicks(std::int64_t ticks) {
        if (!workspace.play.running()) workspace.startPlaying(true);
        const std::int64_t end = workspace.play.ticks() + ticks;
        while (workspace.play.ticks() < end) {
            hands.key(Key::F10);
            hands.rest();
        }
    }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(EffectsPanelTest, showsTheEntitiesThatRequireAnEffectAndAClickSelectsThem) {
    EXPECT_EQ(valueOf("Effects/gravity"), "on");
    EXPECT_EQ(valueOf("Effects/gravity/RigidBody"), "1");
    EXPECT_EQ(valueOf("Effects/drag"), "off");
    EXPECT_EQ(valueOf("Effects/joints"), "off");
    hands.click("Effects/gravity/RigidBody");
    EXPECT_EQ(workspace.document.selection.all(), std::vector<ObjectId>{named("player")});
    hands.click("Effects/running");
    EXPECT_EQ(valueOf("Effects/drag"), "(none)");
    EXPECT_EQ(valueOf("Effects/camera"), "on");
    hands.click("Effects/all");
    EXPECT_EQ(valueOf("Effects/drag"), "off");
}

TEST_F(EffectsPanelTest, followsComponentsAddedToTheScene) {
    EXPECT_EQ(valueOf("Effects/drag/RigidBody"), "(none)");
    auto& body = workspace.document.world.get<RigidBody>(workspace.document.find(named("player")));
    body.linearDrag = 2.0f;
    ++workspace.document.sceneRevision;
    EXPECT_EQ(valueOf("Effects/drag/RigidBody"), "1");
    EXPECT_EQ(valueOf("Effects/drag"), "on");
}

TEST_F(EffectsPanelTest, aPinIsAnUndoableEditOfTheFile) {
    const std::string before = fileText();
    hands.click("Effects/gravity/off");
    EXPECT_EQ(valueOf("Effects/gravity"), "off");
    EXPECT_EQ(valueOf("Effects/gravity/off"), "chosen");
    EXPECT_EQ(workspace.undo.size(), 1u);
    EXPECT_EQ(workspace.undo.label(0), "effect gravity: off");
    hands.click("Effects/drag/on");
    EXPECT_EQ(valueOf("Effects/drag"), "on");
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_NE(fileText().find("\"effects\": {\n    \"gravity\": \"off\",\n    \"drag\": \"on\"\n  }"),
              std::string::npos)
        << fileText();
    hands.click("Effects/gravity/auto");
    EXPECT_EQ(valueOf("Effects/gravity"), "on");
    workspace.undo.undo();
    EXPECT_EQ(valueOf("Effects/gravity/off"), "chosen");
    workspace.undo.undo();
    workspace.undo.undo();
    EXPECT_EQ(valueOf("Effects/gravity/auto"), "chosen");
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_EQ(fileText(), before);
}

TEST_F(EffectsPanelTest, undoRestoresThePinsInTheirOrder) {
    pinEffect(workspace, "wind", Pin::On);
    pinEffect(workspace, "sound", Pin::Off);
    pinEffect(workspace, "particles", Pin::Off);
    const std::string three = workspace.text();
    pinEffect(workspace, "sound", Pin::Auto);
    EXPECT_NE(workspace.text(), three);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), three);
    workspace.undo.redo();
    EXPECT_EQ(workspace.text().find("sound"), std::string::npos);
    pinEffect(workspace, "sound", Pin::Auto);
    EXPECT_EQ(workspace.undo.size(), 4u) << "what changes nothing is no step";
}

TEST_F(EffectsPanelTest, whileTheGamePlaysCostsAreLiveAndPinsStay) {
    EXPECT_EQ(valueOf("Effects/summary"), "Times appear while the game runs.");
    playTicks(20);
    EXPECT_NE(valueOf("Effects/summary").find("Mean tick of the last second: "), std::string::npos);
    EXPECT_EQ(valueOf("Effects/gravity"), "on");
    EXPECT_EQ(valueOf("Effects/friction/cost"), "shared");
    EXPECT_NE(valueOf("Effects/sleep/cost"), "") << "a stage of its own";
    EXPECT_NE(valueOf("Effects/sleep/cost"), "shared");
    hands.click("Effects/gravity/off");
    EXPECT_EQ(valueOf("Effects/gravity/auto"), "chosen") << "the scene is changed while nothing plays";
    EXPECT_EQ(workspace.undo.size(), 0u);
    hands.click("Effects/gravity/RigidBody");
    EXPECT_EQ(workspace.document.selection.all(), std::vector<ObjectId>{named("player")});
}

TEST_F(EffectsPanelTest, theRunningGameUsesThePinsOfTheScene) {
    pinEffect(workspace, "gravity", Pin::Off);
    playTicks(10);
    EXPECT_EQ(valueOf("Effects/gravity"), "off");
    const EntityId player = workspace.play.find(named("player"));
    EXPECT_FLOAT_EQ(workspace.play.world().get<Transform>(player).position.y, 100.0f) << "nothing pulls";
}

TEST_F(EffectsPanelTest, aComponentThatNeedsAPinnedOffEffectIsLogged) {
    putFile("scenes/torch.scene.json",
            R"({"format": 1, "effects": {"particles": "off"}, "layers": [], "entities": [
              {"id": "0000000000000001", "name": "torch", "components": {"Transform": {}, "ParticleEmitter": {}}}]})");
    const Result<LoadReport> report = workspace.open("scenes/torch.scene.json");
    ASSERT_TRUE(report.ok());
    ASSERT_EQ(report->problems.size(), 1u);
    EXPECT_EQ(report->problems[0].text(),
              "scenes/torch.scene.json: effects.particles: it is \"off\", but torch @0000000000000001 has "
              "ParticleEmitter, which needs it; remove ParticleEmitter, or write \"auto\"; the effect "
              "stays off");
}

}  // namespace
}  // namespace plumb::editor
