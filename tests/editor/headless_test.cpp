#include <cstdlib>

#include "app/project.hpp"
#include "app/scene_game.hpp"
#include "core/text.hpp"
#include "editor/model/headless/project_check.hpp"
#include "editor/model/headless/project_export.hpp"
#include "editor/model/project/editor_options.hpp"
#include "platform/paths.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

class HeadlessTest : public EditorFixture {
protected:
    HeadlessTest() : out{fs::temp_directory_path() / (root().filename().string() + "_out")} {
        fs::remove_all(out);
        putFile("project.json", R"({"name": "Test", "startScene": "scenes/level.scene.json"})");
        putFile(kScene, R"({"format": 1, "effects": {}, "layers": [], "entities": [
            {"id": "0000000000000001", "name": "ball", "components": {"Transform": {"position": [10, 20]},
             "RigidBody": {}, "CircleCollider": {"radius": 4}}}]})");
    }
    ~HeadlessTest() override { fs::remove_all(out); }
    [[nodiscard]] const Path& root() const { return workspace.project.root; }
    ProjectCheck check() {
        const Result<Project> project = loadProject(root());
        EXPECT_TRUE(project.ok());
        PrefabLibrary prefabs{workspace.document.types(), root()};
        workspace.assets.clearErrors();
        return checkProject(*project, workspace, prefabs);
    }
    [[nodiscard]] Result<ExportReport> exportIt(const Path& player = {}) const {
        return exportProject(root(), out, {player, engineAssets()});
    }
    static std::uint64_t hashAfter(const Path& folder, int ticks) {
        SceneGame game{*loadProject(folder)};
        game.onCreate();
        for (int i = 0; i < ticks; ++i) tickGame(game, {});
        return game.world.hash();
    }

    Path out;
};

TEST_F(HeadlessTest, aGoodProjectHasNoProblems) {
    const ProjectCheck found = check();
    EXPECT_TRUE(found.problems.empty()) << found.text();
    EXPECT_EQ(found.text(), "1 scene, 0 prefabs, 0 assets: 0 problems\n");
}

TEST_F(HeadlessTest, everyKindOfFaultIsFoundAndReportedOnce) {
    putFile("scenes/broken.scene.json", "{ \"entities\": [");
    putFile("scenes/odd.scene.json", R"({"format": 1, "entities": [{"id": "0000000000000001", "components":
        {"Transform": {"position": "here"}, "Sprite": {"texture": "assets/none.png"}}}]})");
    putFile("prefabs/bad.prefab.json", "[]");
    putFile("assets/bad.tileset.json", "{");
    putFile("project.json",
            R"({"startScene": "scenes/away.scene.json", "input": {"actions": {"Jump": ["Spacce"]}}})");
    const ProjectCheck found = check();
    const std::string text = found.text();
    for (const char* part : {"scenes/broken.scene.json", "position", "assets/none.png",
                             "prefabs/bad.prefab.json", "assets/bad.tileset.json", "startScene", "Spacce"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    EXPECT_FALSE(found.playable);
    EXPECT_EQ(found.scenes, 3u);
}

TEST_F(HeadlessTest, aMissingFileIsReportedWithTheEntityAndFieldThatReferenceIt) {
    putFile("scenes/odd.scene.json", R"({"format": 1, "effects": {}, "layers": [], "entities": [
        {"id": "0000000000000001", "name": "ball",
         "components": {"Transform": {}, "Sprite": {"texture": "assets/none.png"}}},
        {"id": "0000000000000002", "name": "box",
         "components": {"Transform": {}, "Sprite": {"texture": "assets/none.png"}}}]})");
    putFile("prefabs/owl.prefab.json", R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "owl",
        "components": {"Transform": {}, "Sprite": {"texture": "assets/owl.png"}}}]})");
    putFile("assets/set.tileset.json", R"({"format": 1, "image": "assets/tiles.png"})");
    const std::string text = check().text();
    for (const char* line :
         {"assets/none.png: there is no such file, referenced by scenes/odd.scene.json: ball "
          "(0000000000000001), "
          "Sprite.texture and 1 more; ",
          "assets/owl.png: there is no such file, referenced by prefabs/owl.prefab.json: owl "
          "(0000000000000001), "
          "Sprite.texture; ",
          "assets/tiles.png: there is no such file, referenced by assets/set.tileset.json; "})
        EXPECT_NE(text.find(line), std::string::npos) << line << " in\n" << text;
}

TEST_F(HeadlessTest, theContentOfEveryPrefabIsCheckedAlsoOfThoseThatNoSceneUses) {
    putFile("prefabs/lamp.prefab.json", R"({"format": 1, "entities": [{"id": "0000000000000001",
        "components": {"Sprite": {"widht": 3}, "Sprit": {}}}]})");
    putFile("prefabs/post.prefab.json", R"({"format": 1, "entities": [{"id": "0000000000000001"},
        {"id": "0000000000000002", "prefab": "prefabs/lamp.prefab.json", "components": {"Sprite": {"width": "w"}}}]})");
    putFile("assets/shots/ping.prefab.json", R"({"format": 1, "entities": [{"id": "0000000000000001"},
        {"id": "0000000000000002", "prefab": "assets/shots/pong.prefab.json"}]})");
    putFile("assets/shots/pong.prefab.json", R"({"format": 1, "entities": [{"id": "0000000000000001"},
        {"id": "0000000000000002", "prefab": "assets/shots/ping.prefab.json"}]})");
    putFile("prefabs/bag.prefab.json", R"({"format": 1, "entities": [{"id": "0000000000000001"},
        {"id": "0000000000000002", "prefab": "prefabs/lamb.prefab.json"}]})");
    putFile("scenes/post.scene.json", R"({"format": 1, "effects": {}, "layers": [], "entities": [
        {"id": "0000000000000001", "prefab": "prefabs/post.prefab.json"}]})");
    const ProjectCheck found = check();
    const std::string text = found.text();
    for (const char* line :
         {"prefabs/lamp.prefab.json: entities[0].Sprite.widht: ",
          "prefabs/lamp.prefab.json: entities[0].Sprit: ",
          "prefabs/post.prefab.json: entities[1].Sprite.width: expected a whole number, found \"w\"",
          "assets/shots/pong.prefab.json: entities[1].prefab: assets/shots/ping.prefab.json: the prefab "
          "contains "
          "itself, through assets/shots/pong.prefab.json",
          "assets/shots/ping.prefab.json: entities[1].prefab: assets/shots/pong.prefab.json: the prefab "
          "contains "
          "itself, through assets/shots/ping.prefab.json",
          "prefabs/bag.prefab.json: entities[1].prefab: prefabs/lamb.prefab.json: there is no such file; did "
          "you "
          "mean \"prefabs/lamp.prefab.json\"?"})
        EXPECT_NE(text.find(line), std::string::npos) << line << " in\n" << text;
    EXPECT_EQ(found.problems.size(), 6u) << "each once, also those of a prefab in a prefab in a scene:\n"
                                         << text;
}

TEST_F(HeadlessTest, unknownKeysOfAnimationsTilesetsAndTheProjectAreReportedOnce) {
    putFile("assets/run.anim.json", R"({"format": 1, "imag": "assets/none.png"})");
    putFile("assets/set.tileset.json", R"({"format": 1, "colums": 3})");
    putFile("project.json",
            R"({"name": "Test", "startScene": "scenes/level.scene.json", "scalling": "fit"})");
    const std::string text = check().text();
    for (const char* part : {"imag: unknown property; did you mean", "colums: unknown property; did you mean",
                             "project.json: scalling: a project has no such key"}) {
        const std::size_t at = text.find(part);
        ASSERT_NE(at, std::string::npos) << part << " in\n" << text;
        EXPECT_EQ(text.find(part, at + 1), std::string::npos) << part << " twice in\n" << text;
    }
}

/// Only the beginning of each file is valid, so that the damage is found only by decoding the whole file.
TEST_F(HeadlessTest, damagedSoundsFontsAndImagesAreReported) {
    const Path sources = test::sourceFolder();
    const std::string picture = *readFile(sources / "tests/import/maps/meadow.png");
    const std::string sound = *readFile(sources / "projects/platformer/assets/coin.wav");
    const std::string font = *readFile(engineAssets() / "fonts/tiny5.ttf");
    const auto damagedFrom = [](std::string bytes, std::size_t at) {
        std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), 'x');
        return bytes;
    };
    putFile("assets/good.png", picture);
    putFile("assets/good.wav", sound);
    putFile("assets/good.ttf", font);
    EXPECT_TRUE(check().problems.empty()) << check().text();
    const std::pair<const char*, std::string> bad[] = {
        {"assets/bad.png", damagedFrom(picture, 40)},
        {"assets/cut.png", picture.substr(0, picture.size() / 2)},
        {"assets/bad.wav", damagedFrom(sound, 0)},
        {"assets/odd.wav", damagedFrom(sound, 12)},
        {"assets/bad.ogg", damagedFrom(sound, 0)},
        {"assets/bad.ttf", damagedFrom(font, 4)}};
    for (const auto& [name, bytes] : bad) putFile(name, bytes);
    const ProjectCheck found = check();
    EXPECT_EQ(found.problems.size(), std::size(bad)) << found.text();
    for (const auto& [name, bytes] : bad) EXPECT_NE(found.text().find(name), std::string::npos) << name;
}

TEST_F(HeadlessTest, anExportedGamePlaysLikeTheProject) {
    putFile(".plumb/journal", "secret");
    putFile("notes.txt", "taken along");
    putFile("player", "a program");
    const Result<ExportReport> report = exportIt(root() / "player");
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_TRUE(report->runnable);
    EXPECT_FALSE(fs::exists(out / "game/.plumb"));
    EXPECT_TRUE(fs::exists(out / "game/notes.txt"));
    EXPECT_TRUE(fs::exists(out / "assets/fonts"));
    ASSERT_TRUE(fs::exists(engineAssets() / "templates"));
    EXPECT_FALSE(fs::exists(out / "assets/templates")) << "a game needs no templates";
    EXPECT_FALSE(fs::exists(out / "assets/tools"));
    EXPECT_TRUE(fs::exists(out / "plumb-player")) << "the name that the script starts";
    EXPECT_NE(fs::status(out / "play").permissions() & fs::perms::owner_exec, fs::perms::none);
    EXPECT_EQ(hashAfter(out / "game", 60), hashAfter(root(), 60));
}

// On macOS before 12.3, readlink has no option -f.
TEST_F(HeadlessTest, theScriptOfAnExportStartsTheGameThroughLinksWithAReadlinkWithoutOptions) {
    putFile("player", "#!/bin/sh\ncat \"$(dirname \"$0\")/sign\" \"$1/sign\"; echo \"$2\"\n");
    fs::permissions(root() / "player", fs::perms::owner_exec, fs::perm_options::add);
    ASSERT_TRUE(exportIt(root() / "player").ok());
    ASSERT_TRUE(writeFile(out / "sign", "player ").ok());
    ASSERT_TRUE(writeFile(out / "game/sign", "game ").ok());
    const Path links = root() / "with links";
    fs::create_directories(links / "inner");
    putFile("with links/bin/readlink",
            "#!/bin/sh\ncase $1 in -*) exit 1 ;; esac\nPATH=/usr/bin:/bin exec readlink \"$1\"\n");
    fs::permissions(links / "bin/readlink", fs::perms::owner_exec, fs::perm_options::add);
    fs::create_symlink(out / "play", links / "absolute");
    fs::create_symlink("../absolute", links / "inner/relative");
    fs::create_symlink("with links/inner/relative", root() / "first");
    fs::create_directory_symlink(out, links / "folder");
    const std::pair<Path, std::string> calls[] = {{out, "./play"},       {"/", (out / "play").string()},
                                                  {links, "./absolute"}, {links, "inner/relative"},
                                                  {root(), "./first"},   {"/", (root() / "first").string()},
                                                  {links, "folder/play"}};
    for (const auto& [folder, program] : calls) {
        const Path output = root() / "output";
        const std::string command =
            format("cd '{}' && PATH='{}':\"$PATH\" '{}' 'an option' > '{}' 2>&1", folder.string(),
                   (links / "bin").string(), program, output.string());
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
        EXPECT_EQ(*readFile(output), "player game an option\n") << command;
    }
}

// Code loads them: assetsOf(world).loadSound("shot.wav"), spawn(world, "coin").
TEST_F(HeadlessTest, anExportContainsWhatNoSceneRefersTo) {
    const std::string prefab = R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "coin"}]})";
    const std::pair<const char*, std::string> files[] = {
        {"assets/shot.wav", "a sound"},       {"assets/deep/er/hit.ogg", "another"},
        {"assets/spark.png", "a picture"},    {"prefabs/coin.prefab.json", prefab},
        {"scenes/other.scene.json", "scene"}, {"levels.txt", "of the code's own format"},
        {"codes/secret.txt", "not code"},     {"assets/code/door.txt", "not code"}};
    for (const auto& [name, text] : files) putFile(name, text);
    putFile("code/game.cpp", "source");
    ASSERT_TRUE(exportIt().ok());
    for (const auto& [name, text] : files) {
        const Result<std::string> copy = readFile(out / "game" / name);
        ASSERT_TRUE(copy.ok()) << name;
        EXPECT_EQ(*copy, text) << name;
    }
    EXPECT_FALSE(fs::exists(out / "game/code")) << "the player contains it";
}

TEST_F(HeadlessTest, anExportReplacesAnEarlierExportButNoOtherFolder) {
    ASSERT_TRUE(exportIt().ok());
    fs::remove(root() / "notes.txt");
    putFile("assets/new.txt", "new");
    ASSERT_TRUE(writeFile(out / "game/old.txt", "of the last export").ok());
    ASSERT_TRUE(exportIt().ok());
    EXPECT_TRUE(fs::exists(out / "game/assets/new.txt"));
    EXPECT_FALSE(fs::exists(out / "game/old.txt"));

    fs::remove_all(out);
    fs::create_directories(out);
    ASSERT_TRUE(writeFile(out / "thesis.txt", "mine").ok());
    EXPECT_FALSE(exportIt().ok());
    EXPECT_EQ(*readFile(out / "thesis.txt"), "mine");
    EXPECT_FALSE(exportProject(root(), root() / "out", {}).ok()) << "inside the project";
    EXPECT_FALSE(exportProject(root(), root().parent_path(), {}).ok()) << "around the project";
    EXPECT_FALSE(fs::exists(root() / "out"));
}

TEST(EditorOptionsTest, exportOptionsAreParsedAndListedInTheHelp) {
    const std::vector<const char*> words{"mine", "--export", "to"};
    const auto options = parseEditorOptions(words);
    ASSERT_TRUE(options.ok());
    EXPECT_EQ(options->exportTo, "to");
    EXPECT_EQ(options->project, "mine");
    for (const char* option : {"--validate", "--export", "--screenshot"})
        EXPECT_NE(editorUsage().find(option), std::string::npos);
    const std::vector<const char*> cut{"--export"};
    EXPECT_FALSE(parseEditorOptions(cut).ok());
    const std::vector<const char*> jpeg{"--screenshot", "a.jpg"};
    EXPECT_FALSE(parseEditorOptions(jpeg).ok());
}

TEST(EditorOptionsTest, wrongOptionsAreReportedWithTheExpectedOnes) {
    const auto said = [](const std::vector<const char*>& words) {
        const auto options = parseEditorOptions(words);
        return options.ok() ? std::string{} : options.error().text();
    };
    EXPECT_EQ(said({"--validat"}), "command line: unknown option \"--validat\"; did you mean --validate?");
    EXPECT_EQ(
        said({"--theme", "pink"}),
        "command line: invalid value \"pink\" for --theme; write --theme NAME: color theme, dark or light");
    EXPECT_EQ(said({"--size", "12"}),
              "command line: invalid value \"12\" for --size; write --size WxH: window size in px, "
              "320x240 to 8192x8192, e.g. 1600x900");
    EXPECT_EQ(
        said({"--scale"}),
        "command line: --scale needs a value; write --scale RATIO: scale of the user interface, 0.75 to 3");
    EXPECT_EQ(said({"one", "two"}), "command line: \"two\" is a second project; name one project");
    EXPECT_EQ(said({"one", "--import", "level.tmx", "out.scene.json", "--theme=light"}), "");
}

TEST(EditorOptionsTest, theHelpStandsInColumnsThatFitATerminal) {
    const std::string usage = editorUsage();
    const std::vector<std::string_view> lines =
        split(trimmed(std::string_view{usage}.substr(usage.find("\n\n"))), '\n');
    EXPECT_GT(lines.size(), 12u);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_LE(lines[i].size(), 80u) << lines[i];
        ASSERT_GT(lines[i].size(), 26u) << lines[i];
        EXPECT_EQ(lines[i][25], ' ') << lines[i];
        EXPECT_NE(lines[i][26], ' ') << lines[i];
    }
}

}  // namespace
}  // namespace plumb::editor
