#include "app/player.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/log.hpp"
#include "input/recorder.hpp"
#include "scene/systems/physics_system.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

struct Sleeper {
    void update(World&, float) const {}
};

/// A project with an empty scene, played without a window.
class PlayerTest : public testing::Test {
protected:
    PlayerTest() {
        before_ = setLogSink([this](const LogLine& line) {
            if (line.level < LogLevel::Warning) return;
            reported.push_back(line.text);
            channel = line.channel;
        });
        EXPECT_TRUE(
            writeFile(folder_.path / "project.json", R"({"startScene": "scenes/a.scene.json"})").ok());
        EXPECT_TRUE(writeFile(folder_.path / "scenes/a.scene.json", R"({"format": 1, "entities": []})").ok());
        options.project = folder_.path.string();
        options.headless = true;
        options.frames = 3;
    }
    ~PlayerTest() override { setLogSink(before_); }

    std::vector<std::string> reported;
    std::string channel;  ///< of the last one
    PlayerOptions options;

    void write(std::string_view path, std::string_view text) {
        ASSERT_TRUE(writeFile(folder_.path / path, text).ok());
    }

private:
    test::TemporaryFolder folder_;
    LogSink before_;
};

TEST_F(PlayerTest, playsAProjectWhoseCodeIsValid) {
    Module code;
    code.system<Sleeper>(before<PhysicsSystem>());
    EXPECT_EQ(playProject(options, code), 0);
    EXPECT_TRUE(reported.empty()) << reported.front();
}

TEST_F(PlayerTest, doesNotStartWithErrorsOfTheCodeAndReportsEachOnce) {
    Module code;
    code.system<Sleeper>({.after = "Physic"});
    EXPECT_EQ(playProject(options, code), 1);
    EXPECT_EQ(reported,
              (std::vector<std::string>{
                  "code: system \"Sleeper\": there is no system \"Physic\" to run before or after; use "
                  "a system of the engine, e.g. before<PhysicsSystem>(), or one that the code adds "
                  "earlier"}));
    EXPECT_EQ(channel, "Engine") << "an exported game shows these errors in a window, too";
}

TEST_F(PlayerTest, doesNotStartWithoutItsFirstSceneAndReportsItOnce) {
    write("scenes/a.scene.json", "{");
    EXPECT_EQ(playProject(options, {}), 1);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_EQ(reported[0].find("scenes/a.scene.json"), 0u) << reported[0];
    EXPECT_EQ(channel, "Engine") << "an exported game shows these errors in a window, too";
}

TEST_F(PlayerTest, reportsMissingFilesOfAssetsWithoutAWindowToo) {
    write("scenes/a.scene.json", R"({"format": 1, "entities": [{"id": "0000000000000001", "components": {
        "Transform": {}, "Sprite": {"texture": "assets/none.png"},
        "SoundCues": {"step": "assets/none.wav"}}}]})");
    EXPECT_EQ(playProject(options, {}), 0);
    ASSERT_EQ(reported.size(), 2u);
    std::sort(reported.begin(), reported.end());
    EXPECT_EQ(reported[0].find("assets/none.png: there is no such file"), 0u) << reported[0];
    EXPECT_EQ(reported[1].find("assets/none.wav: there is no such file"), 0u) << reported[1];
}

#if !defined(_WIN32)
struct CrashAtTick97 {
    void update(World& world, float) const {
        if (world.tick == 97) std::abort();
    }
};

TEST_F(PlayerTest, keepsTheRecordingOfAGameThatCrashesUpToTheTickOfTheCrash) {
    const Path file = Path{options.project} / "crash.replay";
    options.record = file.string();
    options.seed = 5;
    options.frames = -1;
    Module code;
    code.system<CrashAtTick97>();
    const auto crash = [&] { return playProject(options, code); };
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGABRT), "");
    const Result<Replay> kept = loadReplay(file);
    ASSERT_TRUE(kept.ok()) << kept.error().text();
    EXPECT_EQ(kept->ticks(), 97u) << "with the input of the tick of the crash";
    EXPECT_EQ(kept->seed, 5u);

    options.replay = std::exchange(options.record, {});
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGABRT), "") << "the replay crashes as the game did";
    EXPECT_EQ(playProject(options, {}), 0) << "without the fault it is played to its end";
    EXPECT_TRUE(reported.empty()) << reported.front();
}
#endif

TEST_F(PlayerTest, aRecordingThatCannotBeWrittenIsAnErrorAtTheStart) {
    options.record = (Path{options.project} / "project.json/mine.replay").string();
    EXPECT_EQ(playProject(options, {}), 1);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_NE(reported[0].find("mine.replay: could not be written"), std::string::npos) << reported[0];
}

TEST_F(PlayerTest, playsItsOwnReplayAndRefusesThatOfAnotherProject) {
    const Path file = Path{options.project} / "mine.replay";
    options.record = file.string();
    ASSERT_EQ(playProject(options, {}), 0);
    options.replay = std::exchange(options.record, {});
    options.frames = -1;
    EXPECT_EQ(playProject(options, {}), 0);
    EXPECT_TRUE(reported.empty()) << reported.front();

    ASSERT_TRUE(writeFile(Path{options.project} / "project.json",
                          R"({"name": "Deep Sea", "startScene": "scenes/a.scene.json"})")
                    .ok());
    EXPECT_EQ(playProject(options, {}), 1);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_NE(reported[0].find("recorded by the project"), std::string::npos) << reported[0];
    EXPECT_NE(reported[0].find("this is \"Deep Sea\""), std::string::npos) << reported[0];
}

TEST_F(PlayerTest, theReplayOfOtherCodeDiffersAndNamesTheProjectAndTheVersions) {
    struct Changing {
        void update(World& world, float) const { world.createEntity(); }
    };
    const Path file = Path{options.project} / "mine.replay";
    options.record = file.string();
    ASSERT_EQ(playProject(options, {}), 0);
    options.replay = std::exchange(options.record, {});
    options.frames = -1;
    Module code;
    code.system<Changing>();
    EXPECT_EQ(playProject(options, code), 1);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_NE(reported[0].find("differs from the recorded one at tick 3: the scenes or the code of"),
              std::string::npos)
        << reported[0];
    EXPECT_EQ(reported[0].find("the engine, then"), std::string::npos) << "it is the same: " << reported[0];
    Replay older = *loadReplay(file);
    older.engine = "0.0.9";
    ASSERT_TRUE(writeFile(file, writeReplay(older)).ok());
    EXPECT_EQ(playProject(options, code), 1);
    ASSERT_EQ(reported.size(), 2u);
    EXPECT_NE(reported[1].find("have changed since, or the engine, then 0.0.9, now "), std::string::npos)
        << reported[1];
}

TEST(ExportedName, isThatOfAPlayerThatWasRenamed) {
    const std::pair<const char*, const char*> programs[] = {{"build/release/bin/plumb-player", ""},
                                                            {"plumb-player", ""},
                                                            {"plumb-player.exe", ""},
                                                            {"", ""},
                                                            {"out/Sky Caves", "Sky Caves"},
                                                            {"./Record-player", "Record-player"},
                                                            {"Caves 1.2.exe", "Caves 1.2"},
                                                            {"Caves 1.2", "Caves 1.2"}};
    for (const auto& [program, name] : programs) EXPECT_EQ(exportedName(program, "plumb-player"), name);
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder.path / "plumb-player", "").ok());
    std::filesystem::create_symlink("plumb-player", folder.path / "link");
    EXPECT_EQ(exportedName((folder.path / "link").string(), "plumb-player"), "");
}

}  // namespace
}  // namespace plumb
