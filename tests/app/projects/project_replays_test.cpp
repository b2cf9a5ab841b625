#include "tests/app/projects/project_replays.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/scene_game.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/physics_state.hpp"

// Every project has a recorded game whose hashes are those of every machine, in a window or without one.

namespace plumb {
namespace {

constexpr int kCheckEvery = 100;  // ticks

/// From the menu into its first scenes and back, with a hand that drags. The mouse moves in steps, so that
/// the file stays small.
std::vector<InputFrame> menuAndScenes() {
    constexpr int kScenes = 6;
    constexpr int kVisit = 120;  // ticks
    std::vector<InputFrame> input;
    const auto press = [&](Key key) {
        InputFrame frame;
        frame.set(key, true);
        input.insert(input.end(), 2, frame);
        input.insert(input.end(), 4, InputFrame{});
    };
    for (int scene = 0; scene < kScenes; ++scene) {
        for (int i = 0; i < scene; ++i) press(Key::Down);
        press(Key::Enter);
        for (int tick = 0; tick < kVisit; ++tick) {
            InputFrame frame;
            frame.set(Key::Right, tick % 60 > 30);
            frame.set(Key::Space, tick % 45 == 20);
            if (tick > kVisit / 2) frame.mouseButtons = 1;
            frame.setMouse({static_cast<float>(320 + tick / 10 * 20), 300.0f});
            input.push_back(frame);
        }
        press(Key::Escape);
    }
    return input;
}

SceneGame gameOf(const ProjectReplay& row) { return SceneGame{projectOf(row)}; }

void begin(SceneGame& game) {
    game.assets.logging = false;
    game.onCreate();
    ASSERT_FALSE(game.failed());
}

void recordAnew(const ProjectReplay& row) {
    SceneGame game = gameOf(row);
    begin(game);
    Recorder recorder;
    recorder.replay.project = game.project().name;
    recorder.replay.engine = "0.1.0";
    recorder.replay.scene = game.project().startScene;
    recorder.replay.seed = 1;
    for (const InputFrame& frame : menuAndScenes()) {
        tickGame(game, frame);
        recorder.record(frame);
        if (recorder.ticks() % kCheckEvery == 0) recorder.check(game.world.hash());
    }
    recorder.check(game.world.hash());
    ASSERT_TRUE(saveReplay(recorder.replay, pathOf(row)));
}

/// A body stands on something, or the solver has a contact.
bool somethingTouches(const World& world) {
    const auto* physics = world.findResource<PhysicsState>();
    if (physics != nullptr && physics->world.contacts.size() > 0) return true;
    for (auto [entity, body] : world.query<const RigidBody>()) {
        if (body.grounded) return true;
    }
    return false;
}

/// UPDATE_GOLDEN=1 records those of this file anew: say in the commit which change of the scenes or of the
/// simulation that comes from. The platformer's is made by solve_platformer.
TEST(ProjectReplays, eachPlaysAsItWasRecordedAndDoesSomething) {
    for (const ProjectReplay& row : kProjectReplays) {
        SCOPED_TRACE(row.project);
        const bool ours = std::string_view{row.project} != "platformer";
        if (ours && std::getenv("UPDATE_GOLDEN") != nullptr) recordAnew(row);
        SceneGame game = gameOf(row);
        begin(game);
        std::set<std::string> scenes;
        int touching = 0;
        const Replay replay = replayOf(row);
        ReplayPlayer player{replay};
        while (const InputFrame* frame = player.next()) {
            tickGame(game, *frame);
            scenes.insert(game.world.resource<LoadedScenes>().scenes.front().path);
            touching += somethingTouches(game.world) ? 1 : 0;
            if (const HashCheck* check = player.checkpoint()) {
                ASSERT_EQ(game.world.hash(), check->hash) << "tick " << check->tick;
            }
        }
        EXPECT_GE(replay.checkpoints.size(), 5u);
        EXPECT_GE(scenes.size(), 5u);
        EXPECT_GT(touching, 100);
        EXPECT_LT(std::filesystem::file_size(pathOf(row)), 8192u);
    }
}

TEST(ProjectReplays, noProjectIsLeftOut) {
    for (const auto& folder : std::filesystem::directory_iterator{test::sourceFolder() / "projects"}) {
        const std::string name = folder.path().filename().string();
        const bool known = std::any_of(kProjectReplays.begin(), kProjectReplays.end(),
                                       [&](const ProjectReplay& row) { return name == row.project; });
        EXPECT_EQ(std::filesystem::exists(folder.path() / "project.json"), known) << name;
        // A game in code has its replay beside it: code_game_test.cpp and replay_window.sh play that.
        const auto isReplay = [](const auto& file) { return file.path().extension() == ".replay"; };
        if (!std::filesystem::exists(folder.path() / "main.cpp")) continue;
        EXPECT_TRUE(std::any_of(std::filesystem::directory_iterator{folder.path()},
                                std::filesystem::directory_iterator{}, isReplay))
            << name;
    }
}

}  // namespace
}  // namespace plumb
