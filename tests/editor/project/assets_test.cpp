#include <cmath>

#include "core/clock.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/asset_browser.hpp"
#include "editor/model/assets/hot_reload.hpp"
#include "editor/model/assets/import_task.hpp"
#include "editor/model/assets/move_asset.hpp"
#include "editor/model/assets/place_asset.hpp"
#include "platform/image_file.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/animator.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kUser = R"({
  "format": 1,
  "effects": {},
  "layers": [],
  "entities": [
    {
      "id": "00000000000000b1",
      "name": "coin",
      "components": {
        "Transform": {
          "position": [0, 0]
        },
        "Sprite": {
          "texture": "assets/coin.png"
        }
      }
    }
  ]
}
)";
constexpr std::string_view kTileset =
    R"({"format": 1, "tileSize": [8, 8], "image": "assets/coin.png", "columns": 2, "count": 4})";
constexpr std::string_view kPrefab =
    R"({"format": 1, "entities": [{"name": "box", "components": {"Transform": {}, "Sprite": {"width": 8}}}]})";

std::string png(int width, int height, std::uint8_t shade = 200) {
    const auto bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
    return *encodePng(Image{width, height, std::vector<std::uint8_t>(bytes, shade)});
}

class AssetsTest : public EditorFixture {
protected:
    AssetsTest() {
        putFile("assets/coin.png", png(16, 16));
        putFile("assets/ground.tileset.json", kTileset);
        putFile(
            "assets/run.anim.json",
            R"({"format": 1, "image": "coin.png", "frameSize": [8, 8], "clips": [{"name": "run", "loop": "loop",
                "frames": [{"cell": [0, 0], "seconds": 0.1}]}]})");
        putFile("assets/ping.wav", "RIFFxxxxWAVE");
        putFile("prefabs/box.prefab.json", kPrefab);
        putFile("scenes/user.scene.json", kUser);
    }
    [[nodiscard]] const Path& root() const { return workspace.project.root; }
    [[nodiscard]] bool exists(std::string_view path) const { return std::filesystem::exists(root() / path); }
    template <class T>
    const T& only() {
        return std::as_const(workspace.document.world)
            .get<T>(workspace.document.find(workspace.document.selection.all().at(0)));
    }
};

TEST_F(AssetsTest, theBrowserListsFoldersFirstAndSearchesWords) {
    AssetBrowser browser{workspace};
    EXPECT_EQ(browser.folder, "assets");
    ASSERT_EQ(browser.shown().size(), 4u);
    EXPECT_EQ(browser.shown()[0].name(), "coin.png");
    EXPECT_EQ(browser.shown()[0].kind, AssetKind::Texture);
    browser.enter("");
    EXPECT_TRUE(browser.shown()[0].folder);
    browser.search = "GROUND tile";
    ASSERT_EQ(browser.shown().size(), 1u);
    EXPECT_EQ(browser.describe(browser.shown()[0]), "tileset, 4 tiles of 8 x 8 px");
    browser.search = "";
    browser.enter("assets");
    EXPECT_EQ(browser.describe(browser.shown()[0]), "picture, 16 x 16 px");
}

TEST_F(AssetsTest, aNewFileIsListedAfterTheNextScan) {
    AssetBrowser browser{workspace};
    putFile("assets/new.png", png(4, 4));
    putFile("assets/.hidden.png", png(4, 4));
    browser.refresh();
    EXPECT_EQ(browser.shown().size(), 5u);
}

TEST_F(AssetsTest, renamingUpdatesAllReferencesAndUndoRestoresTheBytes) {
    ASSERT_TRUE(workspace.open("scenes/user.scene.json").ok());
    const std::string tileset = fileText("assets/ground.tileset.json");
    const std::string animation = fileText("assets/run.anim.json");
    AssetBrowser browser{workspace};
    EXPECT_EQ(browser.usesOf("assets/coin.png").size(), 3u);

    ASSERT_EQ(browser.rename("assets/coin.png", "assets/gold.png"), "");

    EXPECT_FALSE(exists("assets/coin.png"));
    EXPECT_TRUE(exists("assets/gold.png"));
    EXPECT_NE(fileText("assets/ground.tileset.json").find("\"assets/gold.png\""), std::string::npos);
    EXPECT_NE(fileText("assets/run.anim.json").find("\"gold.png\""), std::string::npos)
        << "a bare name stays bare";
    EXPECT_NE(workspace.text().find("\"assets/gold.png\""), std::string::npos) << "the open scene follows";
    EXPECT_EQ(fileText("scenes/user.scene.json"), workspace.text());
    EXPECT_EQ(workspace.undo.size(), 1u);

    workspace.undo.undo();
    EXPECT_TRUE(exists("assets/coin.png"));
    EXPECT_EQ(workspace.text(), kUser);
    EXPECT_EQ(fileText("scenes/user.scene.json"), kUser);
    EXPECT_EQ(fileText("assets/ground.tileset.json"), tileset);
    EXPECT_EQ(fileText("assets/run.anim.json"), animation);
    workspace.undo.redo();
    EXPECT_TRUE(exists("assets/gold.png"));
}

TEST_F(AssetsTest, aFolderIsMovedWithItsContentAndEarlierEditsStayUndoable) {
    ASSERT_TRUE(workspace.open("scenes/user.scene.json").ok());
    workspace.undo.push(createEntity(workspace.document, "more", {}));
    workspace.undo.endGesture();
    ASSERT_TRUE(moveAsset(workspace.prefabs(), workspace.assets, "assets", "art/all").ok());

    EXPECT_NE(fileText("art/all/ground.tileset.json").find("\"art/all/coin.png\""), std::string::npos);
    EXPECT_NE(workspace.text().find("\"art/all/coin.png\""), std::string::npos);
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), kUser);
    EXPECT_EQ(fileText("assets/ground.tileset.json"), kTileset);
    workspace.undo.jumpTo(2);
    EXPECT_TRUE(named("more"));
}

TEST_F(AssetsTest, usedNamesAndPathsOutsideTheProjectAreRejected) {
    AssetBrowser browser{workspace};
    for (const char* to : {"scenes/user.scene.json", "../out.png", "", "assets/"}) {
        EXPECT_NE(browser.rename("assets/coin.png", to), "") << to;
        EXPECT_TRUE(exists("assets/coin.png"));
    }
    EXPECT_NE(browser.rename("assets", "assets/deeper"), "");
    EXPECT_NE(browser.rename("assets/none.png", "assets/x.png"), "");
    EXPECT_EQ(workspace.undo.size(), 0u);
}

TEST_F(AssetsTest, onlyWholeTextsAreRenamed) {
    int times = 0;
    const std::string text = R"({"a": "x/b.png", "b.png": "b.png", "c": "B.png \" b.png"})";
    EXPECT_EQ(withRenamedAsset(text, "b.png", "c.png", false, &times),
              R"({"a": "x/b.png", "c.png": "c.png", "c": "B.png \" b.png"})");
    EXPECT_EQ(withRenamedAsset(R"({"a": "x/y.png", "b": "xx/y.png"})", "x", "z", true),
              R"({"a": "z/y.png", "b": "xx/y.png"})");
}

TEST_F(AssetsTest, undoRestoresADeletedFile) {
    AssetBrowser browser{workspace};
    const std::string before = fileText("assets/coin.png");
    ASSERT_EQ(browser.remove("assets/coin.png"), "");
    EXPECT_FALSE(exists("assets/coin.png"));
    workspace.undo.undo();
    EXPECT_EQ(fileText("assets/coin.png"), before);
    EXPECT_NE(browser.remove(kScene), "") << "the open scene stays";
    EXPECT_NE(browser.remove("assets"), "") << "a folder with something in it stays";
}

TEST_F(AssetsTest, filesDroppedIntoTheSceneBecomeMatchingEntities) {
    const std::string before = workspace.text();
    ASSERT_TRUE(placeAsset(workspace, "assets/coin.png", {50.0f, 60.0f}).ok());
    EXPECT_EQ(only<Sprite>().width, 16);
    EXPECT_EQ(only<Transform>().position, (Vec2{50.0f, 60.0f}));
    ASSERT_TRUE(placeAsset(workspace, "assets/run.anim.json", {}).ok());
    EXPECT_EQ(only<Sprite>().width, 8);
    EXPECT_EQ(workspace.assets.animation(only<Animator>().animation).clips.size(), 1u);
    ASSERT_TRUE(placeAsset(workspace, "assets/ground.tileset.json", {}).ok());
    EXPECT_NE(workspace.document.world.tiles().find(only<TileLayer>().cells), nullptr);
    ASSERT_TRUE(placeAsset(workspace, "prefabs/box.prefab.json", {}).ok());
    ASSERT_TRUE(placeAsset(workspace, "assets/ping.wav", {}).ok());
    EXPECT_FALSE(placeAsset(workspace, "scenes/user.scene.json", {}).ok());
    EXPECT_EQ(workspace.undo.size(), 5u);
    EXPECT_NE(workspace.text().find("\"assets/ground.tileset.json\""), std::string::npos);
    workspace.undo.jumpTo(0);
    EXPECT_EQ(workspace.text(), before);
}

TEST_F(AssetsTest, aLayerOfATilesetWithSolidTilesCollides) {
    const World& world = workspace.document.world;
    ASSERT_TRUE(placeAsset(workspace, "assets/ground.tileset.json", {}).ok());
    EXPECT_EQ(world.count<TileCollider>(), 0u) << "none of its tiles is solid";
    std::string solid{kTileset};
    solid.insert(solid.rfind('}'), R"(, "tiles": [{"id": 1, "collision": "full"}])");
    putFile("assets/rock.tileset.json", solid);
    ASSERT_TRUE(placeAsset(workspace, "assets/rock.tileset.json", {-0.3f, 20.6f}).ok());
    EXPECT_EQ(world.count<TileCollider>(), 1u);
    EXPECT_EQ(only<Transform>().position, (Vec2{0.0f, 21.0f})) << "on whole px";
    EXPECT_FALSE(std::signbit(only<Transform>().position.x));
    workspace.undo.jumpTo(0);
    EXPECT_EQ(world.count<TileCollider>(), 0u);
}

/// Moves the modification time of a file forward by 2 s, so that the change is detected.
void touchLater(const Path& file) {
    const auto before = std::filesystem::last_write_time(file);
    std::filesystem::last_write_time(file, before + std::chrono::seconds{2});
}

class HotReloadTest : public AssetsTest {
protected:
    HotReloadTest() : reload{workspace} { reload.poll(now); }
    void put(std::string_view path, std::string_view text) {
        putFile(path, text);
        touchLater(root() / path);
    }
    /// Checks the files for changes once. @return duration, ms
    double look() {
        now += HotReload::kInterval;
        const double before = wallSeconds();
        taken = reload.poll(now);
        return (wallSeconds() - before) * 1000.0;
    }

    HotReload reload;
    double now = 1.0;
    std::size_t taken = 0;
};

TEST_F(HotReloadTest, imagesReferencedOnlyByPartsOfANewInstanceAreLoaded) {
    putFile("prefabs/lamp.prefab.json", R"({"format": 1, "entities": [
        {"id": "0000000000000001", "name": "lamp", "components": {"Transform": {}}},
        {"id": "0000000000000002", "name": "light", "parent": "0000000000000001",
         "components": {"Transform": {}, "Sprite": {"texture": "assets/coin.png"}}}]})");
    ASSERT_TRUE(placeAsset(workspace, "prefabs/lamp.prefab.json", {}).ok());
    const auto loaded = [&] {
        return workspace.assets.revisionOf(AssetKind::Texture, textId("assets/coin.png")) != 0;
    };
    ASSERT_FALSE(loaded());
    reload.poll(now);
    EXPECT_TRUE(loaded()) << "at once, not at the next look";
}

TEST_F(HotReloadTest, everyKindOfFileIsTakenUpWithinATenthOfASecond) {
    const TextureId picture = workspace.assets.loadTexture("assets/coin.png");
    const TilesetId tileset = workspace.assets.loadTileset("assets/ground.tileset.json");
    const AnimationId animation = workspace.assets.loadAnimation("assets/run.anim.json");
    const SoundId sound = workspace.assets.loadSound("assets/ping.wav");
    ASSERT_TRUE(placeAsset(workspace, "prefabs/box.prefab.json", {}).ok());
    ASSERT_TRUE(workspace.save().ok());
    reload.poll(now += 10.0);
    const auto within = [&](const char* kind) {
        const double ms = look() + HotReload::kInterval * 1000.0;
        std::printf("[ %5.1f ms ] %s, at the latest\n", ms, kind);
        EXPECT_GE(taken, 1u) << kind;
        EXPECT_LE(ms, 100.0) << kind;
    };
    put("assets/coin.png", png(24, 8));
    within("texture");
    EXPECT_EQ(workspace.assets.find(picture)->width, 24);
    put("assets/ground.tileset.json", R"({"format": 1, "tileSize": [4, 4], "columns": 1, "count": 9})");
    within("tileset");
    EXPECT_EQ(workspace.assets.tileset(tileset).count, 9);
    put("assets/run.anim.json",
        R"({"format": 1, "clips": [{"name": "walk", "frames": [{"cell": [0, 0]}]}]})");
    within("animation");
    EXPECT_EQ(workspace.assets.animation(animation).clips[0].name, "walk");
    put("assets/ping.wav", "RIFFyyyyyyWAVE");
    within("sound");
    EXPECT_EQ(workspace.assets.find(sound)->bytes.size(), 14u);
    put("prefabs/box.prefab.json",
        R"({"format": 1, "entities": [{"name": "box", "components": {"Transform": {}, "Sprite": {"width": 40}}}]})");
    within("prefab");
    EXPECT_EQ(only<Sprite>().width, 40) << "instances follow where they have nothing of their own";
    std::string scene = fileText();
    scene.replace(scene.find("200,"), 4, "321,");
    put(kScene, scene);
    within("scene");
    EXPECT_EQ(positionOf(named("crate")).x, 321.0f);
    EXPECT_FALSE(workspace.unsaved());
}

/// Found by the random tests. Reloading a scene assigns new entity indices and discards unreferenced tile
/// grids; undo must still restore the deleted entities.
TEST_F(HotReloadTest, undoRestoresDeletedEntitiesAfterAPrefabWasReloaded) {
    ASSERT_TRUE(placeAsset(workspace, "prefabs/box.prefab.json", {}).ok());
    ASSERT_TRUE(workspace.save().ok());
    reload.poll(now += 10.0);
    const std::string before = workspace.text();
    workspace.document.selection.set({named("player"), named("ground")});
    ASSERT_TRUE(runAction(workspace, "edit.delete"));
    put("prefabs/box.prefab.json",
        R"({"format": 1, "entities": [{"name": "box", "components": {"Transform": {}, "Sprite": {"width": 40}}}]})");
    look();
    ASSERT_EQ(taken, 1u);
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(workspace.text(), before);
}

TEST_F(HotReloadTest, unsavedChangesStayWhenAnotherProgramWritesTheScene) {
    workspace.undo.push(createEntity(workspace.document, "mine", {}));
    workspace.undo.endGesture();
    std::string scene = fileText();
    scene.replace(scene.find("200,"), 4, "321,");
    put(kScene, scene);
    look();
    EXPECT_TRUE(named("mine"));
    EXPECT_EQ(positionOf(named("crate")).x, 200.0f);
}

TEST_F(HotReloadTest, filesSavedByTheEditorAreNotReloaded) {
    workspace.undo.push(createEntity(workspace.document, "mine", {}));
    workspace.undo.endGesture();
    ASSERT_TRUE(workspace.save().ok());
    touchLater(root() / kScene);
    look();
    EXPECT_EQ(workspace.undo.size(), 1u) << "undo goes on";
    EXPECT_TRUE(named("mine"));
}

TEST_F(HotReloadTest, aBrokenFileIsReportedAndTheLoadedVersionStays) {
    const TextureId picture = workspace.assets.loadTexture("assets/coin.png");
    put("assets/coin.png", "no picture");
    look();
    EXPECT_EQ(workspace.assets.find(picture)->width, 16);
    put(kScene, "{ broken");
    look();
    EXPECT_TRUE(named("crate"));
}

TEST_F(AssetsTest, aFileToImportIsFoundNamedAndImported) {
    putFile("outside/map.tmx",
            R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
        <layer name="a" width="1" height="1"><data encoding="csv">0</data></layer></map>)");
    putFile("outside/notes.txt", "no map");
    putFile("outside/deep/x.txt", "no map");
    ImportTask task{root()};
    ASSERT_TRUE(task.goTo(root() / "outside"));
    ASSERT_EQ(task.rows().size(), 2u) << "the folder and the map";
    EXPECT_TRUE(task.rows()[0].folder);
    task.choose(task.rows()[1]);
    EXPECT_EQ(task.kind(), "Tiled map");
    EXPECT_EQ(task.target, "scenes/map.scene.json");
    EXPECT_FALSE(task.replaces());
    ASSERT_TRUE(task.run()) << task.problem();
    EXPECT_TRUE(exists("scenes/map.scene.json"));
    EXPECT_TRUE(task.replaces());
    EXPECT_EQ(task.report()->layers, 1);
    task.again();
    task.target = "../elsewhere.scene.json";
    EXPECT_FALSE(task.run());
    EXPECT_NE(task.problem(), "");
    EXPECT_FALSE(task.goTo(root() / "nowhere"));
}

}  // namespace
}  // namespace plumb::editor
