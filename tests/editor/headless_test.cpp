#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <utility>

#include "app/player.hpp"
#include "app/project.hpp"
#include "app/scene_game.hpp"
#include "codec/pack.hpp"
#include "core/text.hpp"
#include "editor/model/headless/project_check.hpp"
#include "editor/model/headless/project_export.hpp"
#include "editor/model/project/program.hpp"
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
        putFile("player", "a program");
        fs::permissions(root() / "player", fs::perms::owner_exec, fs::perm_options::add);
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
    [[nodiscard]] ExportParts parts() const { return {root() / "player", engineAssets(), {}}; }
    [[nodiscard]] Result<ExportReport> exportIt() const {
        return exportProject(*loadProject(root()), out, parts());
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
    EXPECT_EQ(found.scenes, 3u);
    EXPECT_EQ(found.warnings, 1u) << "the key of the project";
    EXPECT_EQ(found.errors(), found.problems.size() - 1);
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

/// Mounts the pack of an export as a player does, for the time of a test.
class MountedExport {
public:
    explicit MountedExport(Path folder) : folder_{std::move(folder)} {
        const Result<std::shared_ptr<const Pack>> pack = Pack::open(folder_ / kPackName);
        EXPECT_TRUE(pack.ok()) << pack.error().text();
        if (pack) mountFiles(folder_, *pack);
    }
    ~MountedExport() { mountFiles(folder_, nullptr); }
    MountedExport(const MountedExport&) = delete;
    MountedExport& operator=(const MountedExport&) = delete;

private:
    Path folder_;
};

TEST_F(HeadlessTest, anExportedGamePlaysLikeTheProject) {
    putFile(".plumb/journal", "secret");
    putFile("notes.txt", "taken along");
    const Result<ExportReport> report = exportIt();
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_EQ(report->program, "Test") << "named like the project";
    EXPECT_NE(fs::status(out / "Test").permissions() & fs::perms::owner_exec, fs::perms::none);
    ASSERT_TRUE(fs::exists(engineAssets() / "templates"));
    const MountedExport mounted{out};
    EXPECT_FALSE(fileExists(out / "game/.plumb/journal"));
    EXPECT_EQ(*readFile(out / "game/notes.txt"), "taken along");
    EXPECT_TRUE(folderExists(out / "assets/fonts"));
    EXPECT_FALSE(folderExists(out / "assets/templates")) << "a game needs no templates";
    EXPECT_FALSE(folderExists(out / "assets/tools"));
    EXPECT_EQ(hashAfter(out / "game", 60), hashAfter(root(), 60));
}

// Code loads them: assetsOf(world).loadSound("shot.wav"), spawn(world, "coin").
TEST_F(HeadlessTest, anExportContainsWhatNoSceneRefersToButNothingThatIsLeftOut) {
    const std::string prefab = R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "coin"}]})";
    const std::pair<const char*, std::string> files[] = {
        {"assets/shot.wav", "a sound"},       {"assets/deep/er/hit.ogg", "another"},
        {"assets/spark.png", "a picture"},    {"prefabs/coin.prefab.json", prefab},
        {"scenes/other.scene.json", "scene"}, {"levels.txt", "of the code's own format"},
        {"codes/secret.txt", "not code"},     {"assets/code/door.txt", "not code"},
        {"assets/art/x.txt", "not left out"}};
    for (const auto& [name, text] : files) putFile(name, text);
    putFile("code/game.cpp", "source");
    putFile("art/hero.svg", "source");
    putFile("notes.txt", "left out, too");
    putFile("project.json", R"({"name": "Test", "startScene": "scenes/level.scene.json",
                                "export": {"leaveOut": ["art/", "notes.txt"]}})");
    ASSERT_TRUE(exportIt().ok());
    const MountedExport mounted{out};
    for (const auto& [name, text] : files) {
        const Result<std::string> copy = readFile(out / "game" / name);
        ASSERT_TRUE(copy.ok()) << name;
        EXPECT_EQ(*copy, text) << name;
    }
    EXPECT_FALSE(folderExists(out / "game/code")) << "the player contains it";
    EXPECT_FALSE(folderExists(out / "game/art"));
    EXPECT_FALSE(fileExists(out / "game/notes.txt"));
}

TEST_F(HeadlessTest, anExportContainsEveryFileHoweverManyThereAre) {
    constexpr std::size_t kFiles = 50'001;
    fs::create_directories(root() / "many");
    for (std::size_t i = 0; i < kFiles; ++i) std::ofstream{root() / "many" / format("{}.txt", i)} << "x";
    putFile("data.tmp", "taken along");
    std::ofstream{root() / "x.json.tmp~"} << "half of a file";
    ASSERT_TRUE(exportIt().ok());
    const MountedExport mounted{out};
    EXPECT_EQ(filesBelow(out / "game/many", "").size(), kFiles);
    EXPECT_TRUE(fileExists(out / "game/data.tmp"));
    EXPECT_FALSE(fileExists(out / "game/x.json.tmp~"));
}

using Content = std::map<std::string, std::string>;  // path in a folder -> bytes

Content contentOf(const Path& folder) {
    Content content;
    for (const std::string& file : filesBelow(folder, "")) content[file] = *readFile(folder / file);
    return content;
}

TEST_F(HeadlessTest, anExportReplacesAnEarlierOneAndLeavesAllOtherFiles) {
    const Content mine{{"notes.txt", "mine"},
                       {"soundtrack/a/1.ogg", "song"},
                       {"game/assets/hero.png", "mod"},
                       {".hidden", "mine"},
                       {"Test.txt", "mine"}};
    for (int round = 0; round < 3; ++round) {
        putFile("assets/new.txt", format("version {}", round));
        putFile("player", format("player {}", round));
        const Result<ExportReport> report = exportIt();
        ASSERT_TRUE(report.ok()) << report.error().text();
        Content found = contentOf(out);
        EXPECT_EQ(found["Test"], format("player {}", round));
        std::vector<std::string> written;
        for (const auto& [file, bytes] : found) {
            if (mine.count(file) == 0) written.push_back(file);
        }
        EXPECT_EQ(report->written, written) << "an archive contains these";
        for (const std::string& file : written) found.erase(file);
        EXPECT_EQ(found, round == 0 ? Content{} : mine);
        for (const auto& [file, bytes] : mine) ASSERT_TRUE(writeFile(out / file, bytes).ok());
    }
}

TEST_F(HeadlessTest, aFolderWithoutAnEarlierExportOfTheGameIsRefusedAndStaysAsItIs) {
    const auto refused = [&](std::string_view why) {
        const Content before = contentOf(out);
        const Result<ExportReport> report = exportIt();
        ASSERT_FALSE(report.ok()) << why;
        EXPECT_NE(report.error().text().find(why), std::string::npos) << report.error().text();
        EXPECT_EQ(contentOf(out), before);
        EXPECT_FALSE(fs::exists(out / ".plumb-export"));
    };
    ASSERT_TRUE(writeFile(out / "thesis.txt", "mine").ok());
    refused("has other content: thesis.txt");
    ASSERT_TRUE(writeFile(out / "game.pack", "x").ok());
    refused("a game.pack that no export wrote");
    ASSERT_TRUE(writeFile(out / "game.pack", writePack({{"tiles.png", "of another program"}})).ok());
    refused("this pack contains no game");
    ASSERT_TRUE(
        writeFile(out / "game.pack", writePack({{"game/project.json", R"({"name": "Caves"})"}})).ok());
    refused("an export of another game, \"Caves\"");

    fs::remove_all(out);
    ASSERT_TRUE(exportIt().ok());
    fs::remove(out / "Test");
    ASSERT_TRUE(writeFile(out / "Test/diary.txt", "mine").ok());
    refused("this folder is in the place of a file");

    const Project project = *loadProject(root());
    EXPECT_FALSE(exportProject(project, root() / "out", parts()).ok()) << "inside the project";
    EXPECT_FALSE(exportProject(project, root().parent_path(), parts()).ok()) << "around the project";
    EXPECT_FALSE(fs::exists(root() / "out"));
}

TEST_F(HeadlessTest, aFileThatNoPackTakesIsRefusedUnlessItIsLeftOut) {
    ASSERT_TRUE(exportIt().ok());
    const Content before = contentOf(out);
    fs::create_directories(root() / "art/deep");
    for (const char* name : {"a:b.txt", "art/a\\b.txt", "art/a\nb.txt", "art/\xff.txt", "art/link"}) {
        if (Path{name}.extension().empty()) {
            fs::create_directory_symlink("deep", root() / name);
        } else {
            putFile(name, "x");
        }
        const Result<ExportReport> report = exportIt();
        ASSERT_FALSE(report.ok()) << name;
        EXPECT_EQ(report.error().where, name);
        EXPECT_NE(report.error().remedy.find("leave it out with export.leaveOut"), std::string::npos);
        EXPECT_EQ(contentOf(out), before);
        fs::remove(root() / name);
    }
    putFile("art/a:b.txt", "x");
    putFile("project.json", R"({"name": "Test", "export": {"leaveOut": ["art/"]}})");
    EXPECT_TRUE(exportIt().ok());
}

TEST_F(HeadlessTest, aFolderWithANameThatTheSystemRefusesIsAnError) {
    const Path link = Path{out}.concat("_loop");
    fs::remove(link);
    fs::create_symlink(link, link);
    for (const Path& folder : {out / std::string(300, 'x'), link / "out", link}) {
        const Result<ExportReport> report = exportProject(*loadProject(root()), folder, parts());
        ASSERT_FALSE(report.ok()) << folder;
        EXPECT_FALSE(report.error().remedy.empty());
    }
    EXPECT_FALSE(fs::exists(out));
    fs::remove(link);
}

TEST_F(HeadlessTest, aFinishedExportIsPlacedAsAWholeOrNotAtAll) {
    const Path finished = Path{out}.concat("_finished");
    fs::remove_all(finished);
    const Project project = *loadProject(root());
    ASSERT_TRUE(exportProject(project, finished, parts()).ok());
    ASSERT_TRUE(placeExport(project, finished, out).ok());
    EXPECT_EQ(contentOf(out), contentOf(finished));
    EXPECT_NE(fs::status(out / "Test").permissions() & fs::perms::owner_exec, fs::perms::none);
    ASSERT_TRUE(placeExport(project, finished, out).ok()) << "again";
    fs::remove_all(out);
    ASSERT_TRUE(writeFile(out / "thesis.txt", "mine").ok());
    EXPECT_FALSE(placeExport(project, finished, out).ok());
    EXPECT_EQ(contentOf(out), (Content{{"thesis.txt", "mine"}}));
    fs::remove_all(finished);
}

TEST_F(HeadlessTest, anExportThatFailsOrWasKilledLeavesNothingBehind) {
    putFile("project.json", R"({"name": "Test", "export": {"icon": "none.png"}})");
    EXPECT_FALSE(exportIt().ok());
    EXPECT_FALSE(fs::exists(out));
    putFile("project.json", R"({"name": "Test"})");
    ASSERT_TRUE(writeFile(out / ".plumb-export/new/game.pack", "half").ok());
    ASSERT_TRUE(exportIt().ok());
    EXPECT_FALSE(fs::exists(out / ".plumb-export"));
}

TEST_F(HeadlessTest, anExportToALinkWritesToTheFolderThatItNames) {
    const Path link = Path{out}.concat("_link");
    fs::remove(link);
    fs::create_directory_symlink(out, link);
    const Project project = *loadProject(root());
    EXPECT_FALSE(exportProject(project, link, parts()).ok()) << "to nothing";
    fs::create_directories(out);
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(exportProject(project, link, parts()).ok());
        EXPECT_TRUE(fs::is_symlink(link));
        EXPECT_TRUE(fs::exists(out / "Test"));
    }
    fs::remove(link);
}

TEST_F(HeadlessTest, anExportWithoutAPlayerIsRefused) {
    const Result<ExportReport> report =
        exportProject(*loadProject(root()), out, {root() / "none", engineAssets(), {}});
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.error().what, "there is no player");
    EXPECT_FALSE(fs::exists(out));
}

TEST_F(HeadlessTest, aPageGetsTheNameAndTheIconOfTheGame) {
    putFile("page/index.html", "<title>{{NAME}}</title><h1>{{NAME}}</h1>{{ICON}}");
    putFile("page/player.js", "script");
    putFile("hero.png", "picture");
    putFile(
        "project.json",
        R"({"name": "A & B <1>", "startScene": "scenes/level.scene.json", "export": {"icon": "hero.png"}})");
    const Result<ExportReport> report =
        exportProject(*loadProject(root()), out, {root() / "page", engineAssets(), {}});
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_EQ(report->program, "index.html");
    EXPECT_EQ(*readFile(out / "index.html"),
              "<title>A &#38; B &#60;1&#62;</title><h1>A &#38; B &#60;1&#62;</h1>icon.png");
    EXPECT_EQ(*readFile(out / "icon.png"), "picture");
    EXPECT_EQ(*readFile(out / "player.js"), "script");
}

/// The words of the line Exec of a desktop entry, as desktops read it. @param place  of the entry
std::vector<std::string> wordsOf(std::string_view exec, const std::string& place) {
    std::string text;  // the first level: escapes of any value
    for (std::size_t i = 0; i < exec.size(); ++i) text += exec[i] == '\\' ? exec[++i] : exec[i];
    std::vector<std::string> words{""};
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') {
            quoted = !quoted;
        } else if (text[i] == ' ' && !quoted) {
            words.emplace_back();
        } else if (text[i] == '%') {
            words.back() += text[++i] == 'k' ? place : std::string{text[i]};
        } else {
            words.back() += text[i] == '\\' ? text[++i] : text[i];
        }
    }
    return words;
}

TEST_F(HeadlessTest, aDesktopStartsTheProgramBesideTheEntry) {
    putFile("player", "#!/bin/sh\nprintf 'played by %s' \"$0\"\n");
    fs::permissions(root() / "player", fs::perms::owner_all);
    putFile("hero.png", "picture");
    for (const char* name : {"Test", "Sky Caves", "a $HOME 100% `id` it's; &", "Über"}) {
        putFile(
            "project.json",
            format(
                R"({"name": "{}", "startScene": "scenes/level.scene.json", "export": {"icon": "hero.png"}})",
                name));
        fs::remove_all(out);
        const Result<ExportReport> report = exportIt();
        ASSERT_TRUE(report.ok()) << report.error().text();
        const std::string entry = *readFile(out / (report->program + ".desktop"));
        EXPECT_NE(entry.find(format("\nName={}\n", name)), std::string::npos) << entry;
        const std::size_t start = entry.find("\nExec=") + 6;
        const ProgramEnd end =
            runProgram(wordsOf(std::string_view{entry}.substr(start, entry.find('\n', start) - start),
                               (out / (report->program + ".desktop")).string()));
        EXPECT_EQ(end.text, "played by " + (out / report->program).string()) << entry;
        EXPECT_EQ(*readFile(out / "icon.png"), "picture");
    }
}

TEST_F(HeadlessTest, anExportContainsTheLicences) {
    putFile("licences/b.txt", "second\n");
    putFile("licences/a.txt", "first\n");
    ASSERT_TRUE(
        exportProject(*loadProject(root()), out, {root() / "player", engineAssets(), root() / "licences"})
            .ok());
    EXPECT_EQ(*readFile(out / "licences.txt"), "a\n=\n\nfirst\n\n\nb\n=\n\nsecond\n\n\n");
}

TEST_F(HeadlessTest, theSameProjectGivesTheSameBytes) {
    ASSERT_TRUE(exportIt().ok());
    const std::string first = *readFile(out / "game.pack");
    for (const char* file : {"project.json", "scenes/level.scene.json"})
        fs::last_write_time(root() / file, fs::file_time_type::clock::now() + std::chrono::hours{24});
    ASSERT_TRUE(exportIt().ok());
    EXPECT_EQ(*readFile(out / "game.pack"), first);
}
}  // namespace
}  // namespace plumb::editor
