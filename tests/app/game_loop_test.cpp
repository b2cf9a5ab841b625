#include "app/game_loop.hpp"

#include <filesystem>
#include <memory>

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include "app/recording/replay_choice.hpp"
#include "app/screen.hpp"
#include "app/sound_place.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "input/recorder.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/transform.hpp"
#include "scene/systems/camera_system.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

TEST(Panning, soundsArePannedByTheirPositionOnScreen) {
    Game game;
    game.world.resource<PictureSize>().size = {320.0f, 180.0f};
    const auto panAt = [&](float x) {
        Entity entity = game.world.createEntity();
        entity.addComponent<Transform>(x, 90.0f);
        return panOf(game.world, entity);
    };
    EXPECT_EQ(panAt(160.0f), 0.0f);
    EXPECT_LT(panAt(0.0f), -0.5f);
    EXPECT_GT(panAt(320.0f), 0.5f);
    EXPECT_EQ(panAt(5000.0f), panAt(320.0f)) << "panning ends at the screen's edge";
    EXPECT_EQ(panOf(game.world, {}), 0.0f);
    Entity camera = game.world.createEntity();
    camera.addComponent<Transform>(1000.0f, 90.0f);
    camera.addComponent<Camera>();
    EXPECT_EQ(panAt(1000.0f), 0.0f);
}

/// A game that reads its own recording while it is written.
class Recorded : public Game {
public:
    explicit Recorded(Path file) : file_{std::move(file)} {}

    std::uint64_t found = 0;  ///< number of ticks in which the file held all, as if the game were killed now

private:
    void onUpdate(float) override {
        const Result<Replay> replay = loadReplay(file_);
        ASSERT_TRUE(replay) << replay.error().text();
        found += replay->ticks() == world.tick ? 1u : 0u;
    }

    Path file_;
};

TEST(Recording, aKilledGameLosesNothingOfItsRecording) {
    const Path file = std::filesystem::temp_directory_path() / "plumb_recording_test.replay";
    std::filesystem::remove(file);
    PlayerOptions options;
    options.headless = true;
    options.frames = 701;
    options.record = file.string();
    Recorded game{file};
    EXPECT_EQ((GameLoop{game, nullptr, options, "recorded"}.run()), 0);
    EXPECT_EQ(game.found, 701u);
    const Result<Replay> whole = loadReplay(file);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->ticks(), 701u);
    std::filesystem::remove(file);
}

TEST(Recording, onAFullDiskTheGameGoesOnAndOneErrorNamesTheTicksOfTheFile) {
    const test::TemporaryFolder folder;
    const Path file = folder.path / "run.replay";
    PlayerOptions options;
    options.headless = true;
    options.frames = 701;
    options.record = file.string();
    const auto play = [&] {
        Game game;
        const int code = GameLoop{game, nullptr, options, "recorded"}.run();
        EXPECT_EQ(game.world.tick, 701u);
        return code;
    };
    ASSERT_EQ(play(), 0);
    // The last bytes are the hash after the last tick, those before the hash after 600.
    const std::uintmax_t size = std::filesystem::file_size(file);
    for (const auto& [missing, ticks] : {std::pair{1, 701}, std::pair{50, 600}}) {
        std::vector<std::string> errors;
        const LogSink before = setLogSink([&](const LogLine& line) {
            if (line.level == LogLevel::Error) errors.push_back(line.text);
        });
        {
            const test::FileSizeLimit limit{size - static_cast<std::uintmax_t>(missing)};
            EXPECT_EQ(play(), 1);
        }
        setLogSink(before);
        ASSERT_EQ(errors.size(), 1u) << missing;
        EXPECT_NE(errors[0].find(format("ends after {} ticks", ticks)), std::string::npos) << errors[0];
        const Result<Replay> read = loadReplay(file);
        ASSERT_TRUE(read.ok()) << read.error().text();
        EXPECT_EQ(read->ticks(), static_cast<std::uint64_t>(ticks));
    }
}

TEST(Recording, aReplayWithoutASeedHasThatOfAGameWithoutTheOption) {
    const Result<Replay> replay = parseReplay("plumb-replay 1\nend 0\n", "run.replay");
    ASSERT_TRUE(replay.ok());
    EXPECT_EQ(replay->seed, seedOf(PlayerOptions{}));
    EXPECT_EQ(replay->scene, PlayerOptions{}.scene);
}

TEST(Recording, aReplayStartsLikeItsGame) {
    const Path file = std::filesystem::temp_directory_path() / "plumb_recording_begin_test.replay";
    Replay replay;
    replay.scene = "scenes/level2.scene.json";
    replay.seed = 42;
    ASSERT_TRUE(writeFile(file, writeReplay(replay)));
    PlayerOptions options;
    options.replay = file.string();
    EXPECT_EQ(begun(options, "Any")->scene, replay.scene) << "a replay that names no project";
    EXPECT_EQ(begun(options, "Any")->seed, 42u);
    std::filesystem::remove(file);
    EXPECT_FALSE(begun(options, "Any").ok()) << "the file is missing";
}

TEST(Recording, eachRunThatIsPlayedLiveHasItsOwnSeed) {
    PlayerOptions live;
    EXPECT_NE(begun(live, "Any")->seed, begun(live, "Any")->seed) << "equal in one of 2^32 runs";
    live.seed = 7;
    EXPECT_EQ(begun(live, "Any")->seed, 7u);
    PlayerOptions headless, ends, picture;
    headless.headless = true;
    ends.frames = 60;
    picture.screenshot = "picture.png";
    for (const PlayerOptions& options : {headless, ends, picture})
        EXPECT_EQ(seedOf(*begun(options, "Any")), 1u);
}

TEST(Recording, ofAnotherProjectIsRefused) {
    const Path file = std::filesystem::temp_directory_path() / "plumb_recording_other_test.replay";
    Replay replay;
    replay.project = "Sky Caves";
    ASSERT_TRUE(writeFile(file, writeReplay(replay)));
    PlayerOptions options;
    options.replay = file.string();
    EXPECT_TRUE(begun(options, "Sky Caves").ok());
    const Result<PlayerOptions> refused = begun(options, "Deep Sea");
    std::filesystem::remove(file);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().what, "it was recorded by the project \"Sky Caves\", and this is \"Deep Sea\"");
}

/// Presses F3 in its fifth tick.
class PressesF3 : public Game {
public:
    int pressed = 0;  ///< ticks in which the game has seen that it was pressed

private:
    void onUpdate(float) override {
        if (world.tick == 5) {
            SDL_Event event{};
            event.type = SDL_KEYDOWN;
            event.key.keysym.scancode = SDL_SCANCODE_F3;
            event.key.keysym.sym = SDLK_F3;
            SDL_PushEvent(&event);
        }
        if (input.isPressed(Key::F3)) ++pressed;
    }
};

TEST(GameLoop, anExportedGameKeepsF3WhichShowsThePhysicsElsewhere) {
    const Result<std::unique_ptr<Screen>> screen = Screen::open({"test", 320, 180, false, {320.0f, 180.0f}});
    ASSERT_TRUE(screen) << screen.error().text();
    for (const std::string_view exportedAs : {"", "My Game"}) {
        int shown = 0;
        const LogSink before =
            setLogSink([&](const LogLine& line) { shown += line.text.find("Physics view on") == 0 ? 1 : 0; });
        PressesF3 game;
        PlayerOptions options;
        options.frames = 20;
        options.exportedAs = exportedAs;
        EXPECT_EQ((GameLoop{game, screen->get(), options, "P"}.run()), 0);
        setLogSink(before);
        EXPECT_EQ(shown, exportedAs.empty() ? 1 : 0);
        EXPECT_EQ(game.pressed, 1) << "it is a key of the game, too";
    }
}

TEST(GameLoop, aPictureOfTheStartIsSavedWithoutATick) {
    const Result<std::unique_ptr<Screen>> screen = Screen::open({"test", 320, 180, false, {320.0f, 180.0f}});
    ASSERT_TRUE(screen) << screen.error().text();
    const test::TemporaryFolder folder;
    PlayerOptions options;
    options.frames = 0;
    options.screenshot = (folder.path / "start.png").string();
    Game game;
    EXPECT_EQ((GameLoop{game, screen->get(), options, "P"}.run()), 0);
    EXPECT_EQ(game.world.tick, 0u);
    EXPECT_TRUE(fileExists(options.screenshot));
}

}  // namespace
}  // namespace plumb
