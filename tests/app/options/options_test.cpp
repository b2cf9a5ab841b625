#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "app/options/game_options.hpp"
#include "app/options/player_settings.hpp"
#include "app/screen.hpp"
#include "core/random.hpp"
#include "platform/paths.hpp"
#include "tests/app/options/options_fixture.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

using test::areValid, test::keyDown, test::project;

// ---- settings

TEST(PlayerSettings, areTheSameAfterWritingAndReading) {
    PlayerSettings settings = project();
    settings.fullscreen = true;
    settings.scale = 3;
    settings.vsync = false;
    settings.frameCap = 144;
    settings.master = 0.35f;
    settings.keys.bind("Jump", {*bindingFromText("K"), *bindingFromText("Pad B")});
    settings.keys.axes[0].negative = {};
    std::vector<Error> warnings;
    EXPECT_EQ(settingsFromText(settingsText(settings, project()), project(), "s", warnings), settings);
    EXPECT_TRUE(warnings.empty());
}

TEST(PlayerSettings, keepTheValuesOfTheProjectForWrongOnes) {
    std::vector<Error> warnings;
    const PlayerSettings settings = settingsFromText(
        R"({"format": 1, "scale": 99, "vsync": "yes", "musik": 1, "music": 0.5,
            "keys": {"actions": {"Fly": ["Space"], "Jump": ["NoKey", "K"]}}})",
        project(), "settings.json", warnings);
    EXPECT_EQ(warnings.size(), 5u);
    PlayerSettings expected = project();
    expected.music = 0.5f;
    expected.keys.bind("Jump", {*bindingFromText("K")});
    EXPECT_EQ(settings, expected);
}

TEST(PlayerSettings, ofEarlierVersionsAreReadWithoutAWarning) {
    std::vector<Error> warnings;
    const std::string text = R"({"format": 1, "music": 0.5, "language": "de"})";
    EXPECT_EQ(settingsFromText(text, project(), "s", warnings).music, 0.5f);
    EXPECT_TRUE(warnings.empty());
}

TEST(PlayerSettings, areInRangeForAnyText) {
    const std::string text = settingsText(project(), PlayerSettings{});
    Random random = Random::seeded(3);
    for (int round = 0; round < 3000; ++round) {
        std::vector<Error> warnings;
        ASSERT_TRUE(areValid(settingsFromText(test::damaged(text, random), project(), "s", warnings)));
    }
}

TEST(PlayerSettings, thatCannotBeReadAreThoseOfTheProject) {
    const test::TemporaryFolder folder;
    std::vector<Error> warnings;
    EXPECT_EQ(readSettings(folder.path / "settings.json", project(), warnings), project());
    EXPECT_TRUE(warnings.empty()) << "there is no file";
    std::filesystem::create_directories(folder.path / "folder");
    EXPECT_EQ(readSettings(folder.path / "folder", project(), warnings), project());
    EXPECT_EQ(warnings.size(), 1u);
}

TEST(PlayerSettings, changeTheWindowAndKeepItsStandardSize) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder.path / "settings.json", R"({"format": 1, "scale": 2, "fullscreen": true})"));
    PlayerOptions options;
    options.saves = folder.path.string();
    const ScreenSettings game{"P", 1280, 720, false, {320.0f, 180.0f}, WindowScale::Fit};
    const ScreenSettings changed = withPlayerSettings(game, options, "P");
    EXPECT_EQ(changed.windowWidth, 640);
    EXPECT_EQ(changed.windowHeight, 360);
    EXPECT_TRUE(changed.fullscreen);
    EXPECT_EQ(changed.standardWidth, 1280);
    EXPECT_EQ(changed.standardHeight, 720);
    options.safe = true;
    EXPECT_EQ(withPlayerSettings(game, options, "P").windowWidth, 1280);
}

TEST(PlayerSettings, thatCannotBeReadAreKeptWhenOthersAreWritten) {
    const test::TemporaryFolder folder;
    const Path file = folder.path / "settings.json", kept = folder.path / "settings.old.json";
    ASSERT_TRUE(writeSettings(file, "first", true)) << "there is no file to keep";
    EXPECT_FALSE(fileExists(kept));
    ASSERT_TRUE(writeSettings(file, "second", true));
    EXPECT_EQ(*readFile(file), "second");
    EXPECT_EQ(*readFile(kept), "first");
    ASSERT_TRUE(writeSettings(file, "third", false));
    EXPECT_EQ(*readFile(kept), "first");
    std::filesystem::remove(kept);
    std::filesystem::create_directories(kept / "inside");
    EXPECT_FALSE(writeSettings(file, "fourth", true));
    EXPECT_EQ(*readFile(file), "third");
}

TEST(PlayerSettings, stayAsTheyWereIfTheDiskIsFull) {
    const test::TemporaryFolder folder;
    const Path file = folder.path / "settings.json";
    ASSERT_TRUE(writeFile(file, "first"));
    {
        const test::FileSizeLimit full{4096};
        EXPECT_FALSE(writeSettings(file, std::string(100'000, 'x'), true));
    }
    EXPECT_EQ(*readFile(file), "first");
}

// ---- the options of a game

TEST(GameOptions, theModeOfTheCommandLineIsForOneRun) {
    const test::TemporaryFolder folder;
    Result<std::unique_ptr<Screen>> screen =
        Screen::open({"test", 640, 360, true, {320.0f, 180.0f}, WindowScale::Fit});
    ASSERT_TRUE(screen) << screen.error().text();
    ASSERT_TRUE((*screen)->window().fullscreen());
    AssetStore assets{{}, engineAssets()};
    SoundOutput sounds{assets};
    FramePacer pacer;
    Input input;
    PlayerOptions run;
    run.saves = folder.path.string();
    GameOptions options{run, "P", **screen, sounds, pacer, input};
    options.handle(keyDown(Key::F10));
    for (int i = 0; i < 4; ++i) options.handle(keyDown(Key::Down));
    options.handle(keyDown(Key::Left));  // the volume
    options.handle(keyDown(Key::Escape));
    std::vector<Error> warnings;
    const PlayerSettings kept = readSettings(folder.path / "settings.json", project(), warnings);
    EXPECT_NEAR(kept.master, 0.9f, 1e-6f);
    EXPECT_FALSE(kept.fullscreen);
}

/// The settings of a game in a window of its own.
struct OptionsOfGame {
    explicit OptionsOfGame(const PlayerOptions& run, const ScreenSettings& settings = kWindow)
        : screen{std::move(*Screen::open(withOptions(withPlayerSettings(settings, run, "P"), run)))},
          options{run, "P", *screen, sounds, pacer, input} {}

    void press(std::initializer_list<Key> keys) {
        for (const Key key : keys) options.handle(keyDown(key));
    }

    inline static const ScreenSettings kWindow{"test", 640, 360, false, {320.0f, 180.0f}, WindowScale::Fit};
    std::unique_ptr<Screen> screen;
    AssetStore assets{{}, engineAssets()};
    SoundOutput sounds{assets};
    FramePacer pacer;
    Input input;
    GameOptions options;
};

TEST(GameOptions, theModeOfTheProjectIsKeptWhenAnotherOptionIsChanged) {
    const test::TemporaryFolder folder;
    PlayerOptions run;
    run.saves = folder.path.string();
    ScreenSettings ofProject = OptionsOfGame::kWindow;
    ofProject.fullscreen = true;
    {
        OptionsOfGame game{run, ofProject};
        ASSERT_TRUE(game.screen->window().fullscreen());
        game.press({Key::F10, Key::Down, Key::Down, Key::Down, Key::Down, Key::Left, Key::Escape});
    }
    ASSERT_TRUE(fileExists(folder.path / "settings.json")) << "the volume was changed";
    OptionsOfGame again{run, ofProject};
    EXPECT_TRUE(again.screen->window().fullscreen());
    again.options.setFullscreen(false);
    EXPECT_FALSE(withPlayerSettings(ofProject, run, "P").fullscreen) << "the player has chosen";
}

TEST(GameOptions, aSizeThatIsChosenInFullscreenIsThatOfTheWindowAfterwards) {
    const test::TemporaryFolder folder;
    PlayerOptions run;
    run.saves = folder.path.string();
    OptionsOfGame game{run};
    Window& window = game.screen->window();
    game.press({Key::F10, Key::Enter, Key::Down, Key::Right});  // fullscreen, 1 x
    ASSERT_TRUE(window.fullscreen());
    game.press({Key::Up, Key::Enter});
    ASSERT_FALSE(window.fullscreen());
    EXPECT_EQ(window.size(), (PixelSize{320, 180}));

    game.press({Key::Enter, Key::Down, Key::Right, Key::Right, Key::Escape});  // fullscreen, 3 x
    ASSERT_TRUE(window.fullscreen());
    window.setFullscreen(false);  // as F11
    game.options.setFullscreen(false);
    EXPECT_EQ(window.size(), (PixelSize{960, 540}));
}

TEST(GameOptions, theLineInTheWindowNamesTheWrongSetting) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder.path / "settings.json", R"({"format": 1, "vsync": "yes"})"));
    PlayerOptions run;
    run.saves = folder.path.string();
    const OptionsOfGame game{run};
    EXPECT_EQ(
        game.options.notice(),
        "Some settings are those of the game: settings.json.vsync: expected true or false, found \"yes\"; "
        "write true or false");
}

TEST(GameOptions, settingsWithoutAFolderForThemAreNotWrittenAnywhere) {
    const test::Variable data{"XDG_DATA_HOME", nullptr}, home{"HOME", nullptr};
    EXPECT_FALSE(playerFolder({}, "P").ok());
    OptionsOfGame game{{}};
    EXPECT_EQ(game.options.notice(), "");
    game.options.setFullscreen(true);
    EXPECT_NE(game.options.notice().find("The settings are not kept: neither HOME"), std::string::npos)
        << game.options.notice();
    EXPECT_NE(game.options.notice().find("--saves DIR"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists("settings.json"));
}

}  // namespace
}  // namespace plumb
