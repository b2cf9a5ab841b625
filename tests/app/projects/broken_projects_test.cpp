#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "platform/image_file.hpp"
#include "render/recording_device.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr const char* kScene = "scenes/main.scene.json";
constexpr std::size_t kEntities = 5;

std::string pngOf(int width, int height) {
    Image image{width, height, {}};
    image.rgba.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 90);
    return *encodePng(image);
}

/// Returns a valid PNG file whose header was changed to state this size.
std::string claiming(unsigned width, unsigned height) {
    std::string png = pngOf(4, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        png[16 + i] = static_cast<char>(width >> (24 - 8 * i));
        png[20 + i] = static_cast<char>(height >> (24 - 8 * i));
    }
    return png;
}

std::string cut(const std::string& bytes, std::size_t by) { return bytes.substr(0, bytes.size() - by); }

/// A complete small game in which one file is broken at a time.
class BrokenProjects : public ::testing::Test {
protected:
    void SetUp() override {
        before_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) reported_.push_back(line.text);
        });
        heal();
        write("../outside/secret.png", pngOf(4, 4));
        write("../outside/secret.tileset.json", kTileset);
    }
    void TearDown() override { setLogSink(before_); }

    void write(const std::string& path, std::string_view bytes) {
        std::error_code ignored;
        std::filesystem::remove(root_ / path, ignored);  // the path may be a link
        ASSERT_TRUE(writeFile(root_ / path, bytes).ok()) << path;
    }
    void remove(const std::string& path) { std::filesystem::remove(root_ / path); }
    void link(const std::string& path, const std::string& to) {
        remove(path);
        std::filesystem::create_symlink(folder_.path / "outside" / to, root_ / path);
    }

    /// Restores all files to their valid state.
    void heal() {
        write("project.json", R"({"name": "Broken", "startScene": "scenes/main.scene.json"})");
        write("assets/hero.png", pngOf(16, 16));
        write("assets/tiles.png", pngOf(16, 16));
        write("assets/sheet.png", pngOf(32, 16));
        write("assets/map.tileset.json", kTileset);
        write("assets/hero.anim.json", kAnimation);
        const Path font = test::sourceFolder() / "projects/platformer/assets/wickwood.ttf";
        write("assets/text.ttf", *readFile(font));
        write("assets/tune.wav", *readFile(test::sourceFolder() / "projects/platformer/assets/coin.wav"));
        write(kScene, kSceneText);
        Result<Project> project = loadProject(root_);
        SceneGame game{*project};
        game.assets.logging = false;
        ASSERT_TRUE(game.openScene(kScene).ok());
        text_ = sceneToJson(game.world, game.context(), sceneId(kScene));
        write(kScene, text_);
        reported_.clear();
    }

    /// Plays and draws five ticks like the player.
    void play() {
        Result<Project> project = loadProject(root_);
        if (!project) return logError("Engine", project.error());
        for (const Error& warning : project->warnings) logWarning("Engine", warning);
        SceneGame game{*project};
        game.onCreate();
        failed_ = game.failure().has_value();
        if (failed_) logError("Engine", *game.failure());
        // Saved before the first tick, because playing may change values.
        if (!failed_) saved_ = sceneToJson(game.world, game.context(), sceneId(kScene));
        RecordingDevice device;
        SceneRenderer renderer{device, game.assets};
        for (int i = 0; i < 5; ++i) {
            tickGame(game, InputFrame{});
            renderer.draw(game.world, {320, 180}, 1.0f, {TargetHandle{}, 0, 0, 320, 180});
        }
        entities_ = game.world.entityCount();
    }

    /// Plays, and expects one reported error with these texts while everything else is loaded and saved.
    void expectOneError(const std::string& where, const std::string& what) {
        reported_.clear();
        play();
        EXPECT_FALSE(failed_);
        EXPECT_EQ(entities_, kEntities);
        EXPECT_EQ(saved_, text_);
        expectReported(where, what);
    }
    /// Expects one error for each of these contents of the file at `path`, and for a missing file.
    void expectOneErrorOfEach(const std::string& path,
                              std::span<const std::pair<std::string, const char*>> kinds) {
        for (const auto& [bytes, what] : kinds) {
            SCOPED_TRACE(bytes.substr(0, 160));
            write(path, bytes);
            expectOneError("", what);
        }
        remove(path);
        expectOneError(path, "");
    }
    void expectReported(const std::string& where, const std::string& what) {
        ASSERT_EQ(reported_.size(), 1u) << ::testing::PrintToString(reported_);
        EXPECT_NE(reported_[0].find(where), std::string::npos) << reported_[0];
        EXPECT_NE(reported_[0].find(what), std::string::npos) << reported_[0];
        EXPECT_NE(reported_[0].find("; "), std::string::npos) << "there is no remedy: " << reported_[0];
    }

    static constexpr const char* kTileset =
        R"({"format": 1, "image": "assets/tiles.png", "tileSize": [8, 8], "columns": 2, "count": 4,
            "tiles": [{"id": 0, "collision": "full"}]})";
    static constexpr const char* kAnimation =
        R"({"format": 1, "image": "assets/sheet.png", "frameSize": [16, 16],
            "clips": [{"name": "idle", "loop": "loop", "frames": [{"cell": [0, 0], "seconds": 0.02},
                                                                  {"cell": [1, 0], "seconds": 0.02}]}],
            "states": [{"name": "idle", "clip": "idle"}]})";
    static constexpr const char* kSceneText = R"({"format": 1, "effects": {}, "layers": [], "entities": [
        {"id": "a1", "components": {"Transform": {}, "Sprite": {"texture": "assets/hero.png"}}},
        {"id": "a2", "components": {"Transform": {}, "TileLayer": {"tileset": "assets/map.tileset.json",
            "cells": {"width": 2, "height": 1, "rows": ["1 2"]}}, "TileCollider": {}}},
        {"id": "a3", "components": {"Transform": {"position": [20, 20]}, "Sprite": {"texture": "assets/sheet.png",
            "width": 16, "height": 16}, "Animator": {"animation": "assets/hero.anim.json"}}},
        {"id": "a4", "components": {"Transform": {}, "Label": {"text": "hello", "font": "assets/text.ttf"}}},
        {"id": "a5", "components": {"Music": {"sound": "assets/tune.wav"}}}]})";

    test::TemporaryFolder folder_;
    Path root_ = folder_.path / "project";
    LogSink before_;
    std::vector<std::string> reported_;
    std::string text_, saved_;
    std::size_t entities_ = 0;
    bool failed_ = false;
};

TEST_F(BrokenProjects, theValidGameReportsNothing) {
    play();
    EXPECT_TRUE(reported_.empty()) << ::testing::PrintToString(reported_);
    EXPECT_EQ(entities_, kEntities);
    EXPECT_EQ(saved_, text_);
}

TEST_F(BrokenProjects, anUnreadableImageIsOneErrorForAllItsUsers) {
    const std::string good = pngOf(64, 64);
    std::string torn = good;
    for (std::size_t i = good.size() / 2; i < good.size(); ++i) torn[i] = static_cast<char>(i * 7);
    const std::pair<const char*, std::string> kinds[] = {
        {"zero bytes", ""},
        {"text", "hello"},
        {"only a signature", good.substr(0, 8)},
        {"no more than a header", good.substr(0, 33)},
        {"cut off", cut(good, 20)},
        {"damaged inside", torn},
        {"no width", claiming(0, 4)},
        {"wider than any card", claiming(100000, 4)},
        {"more than the memory", claiming(16000, 16000)},
        {"a negative size", claiming(0xffffffffu, 0xffffffffu)},
        {"another kind of file", std::string{"GIF89a"} + std::string(40, '\1')},
    };
    for (const char* path : {"assets/hero.png", "assets/tiles.png", "assets/sheet.png"}) {
        SCOPED_TRACE(path);
        for (const auto& [name, bytes] : kinds) {
            SCOPED_TRACE(name);
            write(path, bytes);
            expectOneError(path, "");
        }
        SCOPED_TRACE("missing");
        remove(path);
        expectOneError(path, "");
        link(path, "secret.png");
        expectOneError(path, "leaves the project");
        heal();
    }
}

TEST_F(BrokenProjects, anUnreadableTilesetIsOneErrorAndTheMapKeepsItsTiles) {
    constexpr const char* kPath = "assets/map.tileset.json";
    const std::pair<std::string, const char*> kinds[] = {
        {"", "expected"},
        {"{", "expected"},
        {"[]", "expected"},
        {"null", "expected"},
        {"\xff\xfe", "UTF-8"},
        {std::string(100000, '['), "nested"},
        {R"({"format": 99, "image": "assets/tiles.png"})", "format"},
        {R"({"format": 1, "image": "assets/tiles.png", "tileSize": "big", "columns": 2, "count": 4})",
         "tileSize"},
        {R"({"format": 1, "image": "assets/tiles.png", "tileSize": [0, 8], "columns": 2, "count": 4})",
         "tileSize"},
        {R"({"format": 1, "image": "assets/tiles.png", "tileSize": [8, 8], "columns": -2, "count": 4})",
         "columns"},
        {R"({"format": 1, "image": "assets/tiles.png", "tileSize": [8, 8], "columns": 2, "count": 99999999})",
         "count"},
        {R"({"format": 1, "image": "assets/nowhere.png", "tileSize": [8, 8], "columns": 2, "count": 4})",
         "nowhere.png"},
        {R"({"format": 1, "image": "../outside/secret.png", "tileSize": [8, 8], "columns": 2, "count": 4})",
         R"(contains "..")"},
        {R"({"format": 1, "image": "assets/tiles.png", "tileSize": [8, 8], "columns": 2, "count": 4,
             "tiles": [{"id": 0, "collision": "round"}]})",
         "collision"},
        {R"({"format": 1, "image": "assets/tiles.png", "tileSize": [8, 8], "columns": 2, "count": 4,
             "tiles": [{"id": 0, "collision": [[0, 0], [1, 1]]}]})",
         "collision"},
        {R"({"format": 1, "image": "assets/tiles.png", "tileSize": [8, 8], "columns": 2, "count": 4,
             "tiles": [{"id": 0}, {"id": 0}]})",
         "the same id"},
    };
    expectOneErrorOfEach(kPath, kinds);
    link(kPath, "secret.tileset.json");
    expectOneError(kPath, "leaves the project");
}

TEST_F(BrokenProjects, anUnreadableAnimationIsOneErrorAndItsSpriteRemains) {
    constexpr const char* kPath = "assets/hero.anim.json";
    const std::pair<std::string, const char*> kinds[] = {
        {"", "expected"},
        {"{\"clips\": [", "expected"},
        {"42", "expected"},
        {"\xc3\x28", "UTF-8"},
        {R"({"format": 99})", "format"},
        {R"({"format": 1, "image": "assets/nowhere.png", "frameSize": [16, 16],
             "clips": [{"name": "idle", "frames": [{"cell": [0, 0]}]}], "states": [{"name": "idle", "clip": "idle"}]})",
         "nowhere.png"},
        {R"({"format": 1, "image": "assets/sheet.png", "frameSize": [16, 16],
             "clips": [{"name": "idle", "frames": []}], "states": [{"name": "idle", "clip": "idle"}]})",
         "frames"},
        {R"({"format": 1, "image": "assets/sheet.png", "frameSize": [16, 16],
             "clips": [{"name": "idle", "frames": [{"cell": [-4, 0]}]}], "states": [{"name": "idle", "clip": "idle"}]})",
         "cell"},
        {R"({"format": 1, "image": "assets/sheet.png", "frameSize": [16, 16],
             "clips": [{"name": "idle", "frames": [{"cell": [0, 0], "seconds": 0}]}],
             "states": [{"name": "idle", "clip": "idle"}]})",
         "seconds"},
        {R"({"format": 1, "image": "assets/sheet.png", "frameSize": [16, 16],
             "clips": [{"name": "idle", "frames": [{"cell": [0, 0]}]}],
             "states": [{"name": "idle", "clip": "idle"}, {"name": "run", "clip": "run"}]})",
         "\"run\""},
    };
    expectOneErrorOfEach(kPath, kinds);
}

TEST_F(BrokenProjects, anUnreadableFontOrSoundIsOneError) {
    const std::string font = *readFile(root_ / "assets/text.ttf");
    for (const std::string& bytes : {std::string{}, std::string{"hello"}, font.substr(0, 12),
                                     font.substr(0, 200), std::string(4096, '\xff')}) {
        SCOPED_TRACE(bytes.size());
        write("assets/text.ttf", bytes);
        expectOneError("assets/text.ttf", "");
    }
    remove("assets/text.ttf");
    expectOneError("assets/text.ttf", "");
    heal();
    write("assets/tune.wav", "");
    expectOneError("assets/tune.wav", "empty");
    remove("assets/tune.wav");
    expectOneError("assets/tune.wav", "");
}

TEST_F(BrokenProjects, anUnreadableProjectIsOneErrorAndNothingStarts) {
    const std::pair<std::string, const char*> kinds[] = {
        {"", "expected"},
        {"{\"name\": \"x\"", "expected"},
        {"[1]", "expected an object"},
        {"\"text\"", "expected an object"},
        {"\xff\xff", "UTF-8"},
        {std::string(100000, '{'), "expected"},
        {R"({"name": "x"})", "startScene"},
        {R"({"startScene": "scenes/nowhere.scene.json"})", "nowhere"},
        {R"({"startScene": "../outside/main.scene.json"})", R"(contains "..")"},
        {R"({"startScene": "/etc/passwd"})", "absolute"},
    };
    for (const auto& [bytes, what] : kinds) {
        SCOPED_TRACE(bytes.substr(0, 80));
        write("project.json", bytes);
        reported_.clear();
        entities_ = 0;
        play();
        EXPECT_EQ(entities_, 0u);
        expectReported("", what);
    }
    remove("project.json");
    reported_.clear();
    play();
    expectReported("project.json", "");
}

TEST_F(BrokenProjects, aWrongValueInTheProjectIsOneWarningAndTheGameRuns) {
    const std::pair<const char*, const char*> kinds[] = {
        {R"("window": 3)", "window"},
        {R"("window": {"width": "wide"})", "window.width"},
        {R"("resolution": [0, 0])", "resolution"},
        {R"("resolution": [320])", "resolution"},
        {R"("scaling": "huge")", "scaling"},
        {R"("physics": {"gravity": "down"})", "gravity"},
        {R"("physics": {"pixelsPerMetre": -1})", "pixelsPerMetre"},
        {R"("input": {"actions": {"Jump": ["Spacebaar"]}})", "Spacebaar"},
        {R"("input": {"actions": 4})", "actions"},
        {R"("pauseScene": 7)", "pauseScene"},
        {R"("name": "one", "name": "two")", "appears twice"},
    };
    for (const auto& [property, what] : kinds) {
        SCOPED_TRACE(property);
        std::string text = R"({"startScene": "scenes/main.scene.json", )";
        write("project.json", text.append(property).append("}"));
        expectOneError("project.json", what);
    }
}

TEST_F(BrokenProjects, aSceneOrAFolderThatLeadsOutOfTheProjectIsNotRead) {
    write("../outside/main.scene.json", text_);
    link(kScene, "main.scene.json");
    play();
    EXPECT_TRUE(failed_);
    expectReported(kScene, "leaves the project");
    heal();

    write("scenes/linked.scene.json", text_);
    std::filesystem::create_directory_symlink(folder_.path / "outside", root_ / "link");
    write("project.json", R"({"startScene": "link/main.scene.json"})");
    reported_.clear();
    play();
    EXPECT_TRUE(failed_);
    expectReported("link/main.scene.json", "leaves the project");
}

}  // namespace
}  // namespace plumb
