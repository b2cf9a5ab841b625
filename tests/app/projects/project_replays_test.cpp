#include "tests/app/projects/project_replays.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/scene_game.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/files/scene_path.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/app/playground/pinball_hands.hpp"

// Every project has a replay whose hashes are equal on all machines, with and without a window.

namespace plumb {
namespace {

constexpr int kCheckEvery = 100;  // ticks

/// Scripted input: from the menu into the first scenes and back, with mouse drags. The mouse moves in coarse
/// steps, so that the replay file stays small.
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

void begin(SceneGame& game) {
    game.onCreate();
    ASSERT_FALSE(game.failure());
}

bool isOneScene(const ProjectReplay& row) { return !std::string_view{row.scene}.empty(); }

void recordAnew(const ProjectReplay& row) {
    constexpr std::size_t kPinball = 2400;  // ticks
    ProjectGame played{projectOf(row), row.scene};
    SceneGame& game = played.game;
    begin(game);
    Recorder recorder;
    recorder.replay.project = game.project().name;
    recorder.replay.engine = "0.1.0";
    recorder.replay.scene = isOneScene(row) ? scenePath(row.scene) : game.project().startScene;
    recorder.replay.seed = 1;
    const std::vector<InputFrame> scripted = isOneScene(row) ? std::vector<InputFrame>{} : menuAndScenes();
    const std::size_t ticks = isOneScene(row) ? kPinball : scripted.size();
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        const InputFrame frame = isOneScene(row) ? pinballHands(game.world) : scripted[tick];
        tickGame(game, frame);
        recorder.record(frame);
        if (recorder.ticks() % kCheckEvery == 0) recorder.check(game.world.hash());
    }
    if (recorder.ticks() % kCheckEvery != 0) recorder.check(game.world.hash());
    ASSERT_TRUE(writeFile(pathOf(row), writeReplay(recorder.replay)));
}

/// True if a body is grounded or the solver has a contact.
bool somethingTouches(const World& world) {
    const auto* physics = world.findResource<PhysicsState>();
    if (physics != nullptr && physics->world.contacts.size() > 0) return true;
    for (auto [entity, body] : world.query<const RigidBody>()) {
        if (body.grounded) return true;
    }
    return false;
}

/// UPDATE_GOLDEN=1 records the replays of this file again; the commit must name the change of the scenes or
/// of the simulation that caused it. The platformer's replay is created by solve_platformer.
TEST(ProjectReplays, eachReplayHasItsRecordedHashesAndHasContacts) {
    for (const ProjectReplay& row : kProjectReplays) {
        SCOPED_TRACE(row.replay);
        const bool ours = std::string_view{row.project} != "platformer";
        if (ours && std::getenv("UPDATE_GOLDEN") != nullptr) recordAnew(row);
        ProjectGame played{projectOf(row), row.scene};
        SceneGame& game = played.game;
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
        EXPECT_GE(scenes.size(), isOneScene(row) ? 1u : 5u);
        EXPECT_GT(touching, 100);
        EXPECT_LT(std::filesystem::file_size(pathOf(row)), 8192u);
    }
}

TEST(ProjectReplays, noProjectIsLeftOut) {
    for (const auto& folder : std::filesystem::directory_iterator{test::sourceFolder() / "projects"}) {
        const std::string name = folder.path().filename().string();
        const bool known = std::any_of(kProjectReplays.begin(), kProjectReplays.end(),
                                       [&](const ProjectReplay& row) { return name == row.project; });
        // A project with code needs its own player, which the test arena.replay runs.
        const bool hasCode = std::filesystem::exists(folder.path() / "code");
        EXPECT_EQ(std::filesystem::exists(folder.path() / "project.json") && !hasCode, known) << name;
        const Path ofCode = test::sourceFolder() / "tests/replay" / (name + ".replay");
        EXPECT_TRUE(!hasCode || std::filesystem::exists(ofCode)) << name;
        // The replay of a game in code is in its own folder; code_game_test.cpp and replay_window.sh play it.
        const auto isReplay = [](const auto& file) { return file.path().extension() == ".replay"; };
        if (!std::filesystem::exists(folder.path() / "main.cpp")) continue;
        EXPECT_TRUE(std::any_of(std::filesystem::directory_iterator{folder.path()},
                                std::filesystem::directory_iterator{}, isReplay))
            << name;
    }
}

}  // namespace
}  // namespace plumb
