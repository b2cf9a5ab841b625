#include <algorithm>
#include <cmath>

#include "editor/model/actions.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/play/game_session.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/editor/support/played_games.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

/// A scene with a player on the ground and, to the right, a ledge of the given height, px.
std::string ledgeScene(float height) {
    return format(R"({"format": 1, "entities": [
  {"id": "0000000000000001", "name": "ground", "components": {"Transform": {"position": [-1000, 100]},
   "BoxCollider": {"width": 3000, "height": 40}}},
  {"id": "0000000000000002", "name": "player", "components": {"Transform": {"position": [0, 76]},
   "RigidBody": { }, "BoxCollider": {"width": 12, "height": 20}, "PlayerController": { }}},
  {"id": "0000000000000003", "name": "ledge", "components": {"Transform": {"position": [60, {}]},
   "BoxCollider": {"width": 80, "height": 8}}}]})",
                  100.0f - height);
}

/// Overlays for the reach of jumps and for trajectories.
class Ways : public EditorFixture {
protected:
    Ways() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            project.actions = ActionMap::defaults();
            return makeGameSession(project, path, text);
        };
    }
    void open(const std::string& text) {
        putFile("scenes/ways.scene.json", text);
        ASSERT_TRUE(workspace.open("scenes/ways.scene.json").ok());
        workspace.document.selection.set({named("player")});
    }
    void findOut() {
        for (int i = 0; i < 4000; ++i) {
            workspace.update(1.0 / 60.0);
            if (reach().done() && !reach().landings().empty()) return;
        }
        FAIL() << "it never ends";
    }
    [[nodiscard]] const JumpReach& reach() const { return workspace.reach.reach(); }
    /// True if a predicted jump ends on top of the ledge.
    [[nodiscard]] bool landsOn(float height) const {
        return std::any_of(reach().landings().begin(), reach().landings().end(), [&](const auto& landing) {
            return std::abs(landing.box.max.y - (100.0f - height)) < 2.0f && landing.box.max.x > 60.0f;
        });
    }
    /// Height of the highest jump in the game, with the jump key held, px.
    [[nodiscard]] float highestJump() {
        const auto session = workspace.makeSession(workspace.document.scenePath, workspace.text());
        const EntityId player = entityIn(session->world(), named("player"));
        float highest = 1e9f;
        float ground = 0.0f;
        for (int tick = 0; tick < 120; ++tick) {
            InputFrame frame;
            frame.set(Key::Space, tick > 30);
            session->tick(frame);
            const float y = std::as_const(session->world()).get<Transform>(player).position.y;
            if (tick == 30) ground = y;
            highest = std::min(highest, y);
        }
        return ground - highest;
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(Ways, aLedgeIsReachedExactlyWhenTheEngineCanJumpThatHigh) {
    open(ledgeScene(30.0f));
    const float high = highestJump();
    ASSERT_GT(high, 20.0f);
    for (const float height : {high * 0.5f, high - 3.0f, high + 6.0f, high * 1.5f}) {
        SCOPED_TRACE(height);
        open(ledgeScene(height));
        workspace.setReach("reach", PhysicsReach::Selected);
        findOut();
        EXPECT_EQ(landsOn(height), height < high);
        EXPECT_TRUE(reach().reaches({0.0f, 100.0f - high + 4.0f})) << "straight up";
        EXPECT_FALSE(reach().reaches({0.0f, 100.0f - 2.0f * high - 60.0f}));
        EXPECT_FALSE(reach().reaches({0.0f, 110.0f})) << "inside of the ground";
    }
}

TEST_F(Ways, theReachFollowsEditsOfTheScene) {
    open(ledgeScene(30.0f));
    workspace.setReach("reach", PhysicsReach::Selected);
    findOut();
    ASSERT_TRUE(landsOn(30.0f));
    const TypeInfo& type = workspace.document.types().of<Transform>();
    std::vector<SetField::Change> change;
    change.push_back({named("ledge"), FieldValue::of(Vec2{60, -500})});
    workspace.undo.push(std::make_unique<SetField>(type, *type.find("position"), std::move(change)));
    workspace.undo.endGesture();
    findOut();
    EXPECT_FALSE(landsOn(30.0f));
    workspace.undo.undo();
    findOut();
    EXPECT_TRUE(landsOn(30.0f));
}

TEST_F(Ways, theReachIsThatOfTheSelectedOrOfAnyPlayerAndDoesNotChangeTheScene) {
    open(ledgeScene(30.0f));
    const std::string before = workspace.text();
    const std::uint64_t hash = workspace.document.world.hash();
    workspace.document.selection.clear();
    workspace.setReach("reach", PhysicsReach::Selected);
    workspace.update(0.1);
    EXPECT_TRUE(reach().landings().empty());
    workspace.setReach("reach", PhysicsReach::All);
    findOut();
    EXPECT_FALSE(reach().landings().empty());
    EXPECT_EQ(workspace.text(), before);
    EXPECT_EQ(workspace.document.world.hash(), hash);
    workspace.setReach("reach", PhysicsReach::Off);
    workspace.update(0.1);
    EXPECT_TRUE(reach().cells().empty());
}

TEST_F(Ways, whileItPlaysTheReachIsFromWhereThePlayerStandsAndTheGameGoesOnAsItWould) {
    open(ledgeScene(30.0f));
    PlayMode alone;
    alone.start(workspace.makeSession(workspace.document.scenePath, workspace.text()));
    workspace.startPlaying();
    workspace.setReach("reach", PhysicsReach::Selected);
    InputFrame right;
    right.set(Key::Right, true);
    for (int tick = 0; tick < 90; ++tick) {
        workspace.play.step(right);
        alone.step(right);
        workspace.update(1.0 / 60.0);
    }
    EXPECT_EQ(workspace.play.world().hash(), alone.world().hash());
    workspace.play.setPaused(true);
    findOut();
    const float x =
        std::as_const(workspace.play.world()).get<Transform>(workspace.play.find(named("player"))).position.x;
    ASSERT_GT(x, 100.0f);
    EXPECT_NEAR(reach().landings().front().box.min.x, x, 30.0f);
}

TEST_F(Ways, theListOfLayersHasWaysOfAllOfTheSelectedOrOfNone) {
    open(ledgeScene(30.0f));
    hands.rest(2);
    for (const std::string name : {"reach", "trajectories", "names"}) {
        hands.click("Overlay/physics layers");
        hands.rest(2);
        hands.click("Overlay/physics/" + name + "/selected");
        EXPECT_EQ(workspace.reachOf(name), PhysicsReach::Selected);
        hands.click("Overlay/physics/" + name + "/all");
        EXPECT_EQ(workspace.reachOf(name), PhysicsReach::All);
        hands.click("Overlay/physics/" + name + "/off");
        EXPECT_EQ(workspace.reachOf(name), PhysicsReach::Off);
        hands.key(Key::Escape);
    }
    hands.key(Key::F3, {.shift = true});
    EXPECT_TRUE(workspace.shows("reach"));
    hands.key(Key::F3, {.control = true});
    EXPECT_TRUE(workspace.shows("trajectories"));
}

TEST_F(Ways, trajectoriesAreTheWaysThatTheGameThenGoes) {
    open(ledgeScene(30.0f));
    workspace.setReach("trajectories", PhysicsReach::Selected);
    for (int i = 0; i < 200 && (i < 2 || !workspace.trajectories.done()); ++i) workspace.update(1.0 / 60.0);
    ASSERT_EQ(workspace.trajectories.ways().size(), 1u);
    const std::vector<Vec2> ahead = workspace.trajectories.ways()[0].future;
    ASSERT_EQ(ahead.size(), static_cast<std::size_t>(Trajectories::kAhead));

    workspace.startPlaying(true);
    const auto position = [&] {
        return std::as_const(workspace.play.world())
            .get<Transform>(workspace.play.find(named("player")))
            .position;
    };
    std::vector<Vec2> gone{position()};
    for (const Vec2 place : ahead) {
        workspace.play.step({});
        gone.push_back(position());
        ASSERT_EQ(position(), place);
    }
    // After seeking back, the past and the future path equal the recorded positions.
    workspace.play.seek(70);
    for (int i = 0; i < 400 && (i < 2 || !workspace.trajectories.done()); ++i) workspace.update(1.0 / 60.0);
    const Trajectories::Way& way = workspace.trajectories.ways()[0];
    ASSERT_EQ(way.past.size(), static_cast<std::size_t>(Trajectories::kBehind) + 1);
    for (std::size_t i = 0; i < way.past.size(); ++i) ASSERT_EQ(way.past[i], gone[10 + i]);
    ASSERT_GE(way.future.size(), 50u);
    for (std::size_t i = 0; i < 50; ++i) ASSERT_EQ(way.future[i], gone[71 + i]);
}

}  // namespace
}  // namespace plumb::editor::ui
