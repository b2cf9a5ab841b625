#include "scene/files/scene_assets.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "platform/image_file.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/persistent.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

/// A project with two scenes: `one` uses a.png and both.png; `two` uses b.png, both.png and a map whose
/// tileset has an image of its own.
class SceneAssetsTest : public ::testing::Test {
protected:
    void SetUp() override {
        registerSceneComponents(types_);
        assets_.logging = false;
        world_.provide(assets_);
        Image image{8, 8, {}};
        image.rgba.assign(8 * 8 * 4, 200);
        for (const char* name : {"a", "b", "both", "tiles", "kept"})
            write(std::string{"assets/"}.append(name).append(".png"), *encodePng(image));
        write("assets/map.tileset.json",
              R"({"format": 1, "image": "assets/tiles.png", "tileSize": [4, 4], "columns": 2, "count": 4})");
        write("scenes/one.scene.json", scene({sprite("a"), sprite("both")}));
        write("scenes/two.scene.json",
              scene({sprite("b"), sprite("both"), R"("TileLayer": {"tileset": "assets/map.tileset.json"})"}));
    }

    void write(const std::string& path, std::string_view text) {
        ASSERT_TRUE(writeFile(folder_.path / path, text).ok());
    }
    static std::string sprite(const std::string& name) {
        std::string text = R"("Sprite": {"texture": "assets/)";
        return text.append(name).append(R"(.png"})");
    }
    std::string scene(const std::vector<std::string>& components) {
        std::string text = R"({"format": 1, "effects": {}, "layers": [], "entities": [)";
        for (const std::string& component : components) {
            if (text.back() != '[') text += ',';
            text.append(R"({"id": ")").append(hexText(++ids_)).append(R"(", "components": {)");
            text.append(component).append("}}");
        }
        return text.append("]}");
    }
    /// Replaces the scene `from` by `to` like games do: loads the new scene before it unloads the old one.
    void go(const std::string& to, const std::string& from) {
        ASSERT_TRUE(loadSceneFile(world_, context_, to).ok());
        if (!from.empty()) unloadScene(world_, sceneId(from));
        held_.follow(world_, types_);
        assets_.unloadUnused();
    }
    bool isLoaded(const std::string& name) {
        return assets_.find(TextureId{textId("assets/" + name)}) != nullptr;
    }

    test::TemporaryFolder folder_;
    TypeRegistry types_;
    AssetStore assets_{folder_.path};
    World world_{types_};
    SceneContext context_{types_, nullptr, folder_.path};
    SceneAssets held_{assets_};
    std::uint64_t ids_ = 100;
};

constexpr const char* kOne = "scenes/one.scene.json";
constexpr const char* kTwo = "scenes/two.scene.json";

TEST_F(SceneAssetsTest, assetsOfASceneAreHeldAndReleasedWithIt) {
    go(kOne, "");
    EXPECT_TRUE(isLoaded("a.png") && isLoaded("both.png"));
    EXPECT_EQ(assets_.references(AssetKind::Texture, textId("assets/a.png")), 1);

    go(kTwo, kOne);
    EXPECT_FALSE(isLoaded("a.png"));
    EXPECT_TRUE(isLoaded("b.png") && isLoaded("both.png") && isLoaded("tiles.png"));

    unloadScene(world_, sceneId(kTwo));
    held_.follow(world_, types_);
    assets_.unloadUnused();
    EXPECT_EQ(assets_.size(), 0u);
}

TEST_F(SceneAssetsTest, sharedAssetsAreReadOnceInAHundredSwitches) {
    go(kOne, "");
    const std::size_t size = assets_.size();
    const std::size_t bytes = assets_.byteCount();
    const std::size_t loads = assets_.loadCount();

    for (int i = 0; i < 50; ++i) {
        go(kTwo, kOne);
        go(kOne, kTwo);
        ASSERT_EQ(assets_.size(), size) << i;
        ASSERT_EQ(assets_.byteCount(), bytes) << i;
    }

    // A round of both switches reads six files: two.scene, b.png, the tileset and its image, then one.scene
    // and a.png.
    EXPECT_EQ(assets_.loadCount() - loads, 50u * 6u);
    EXPECT_EQ(assets_.revisionOf(AssetKind::Texture, textId("assets/both.png")), 1u);
}

TEST_F(SceneAssetsTest, persistentAndSpawnedEntitiesKeepTheirAssets) {
    go(kOne, "");
    Entity own = world_.createEntity();
    own.addComponent<Sprite>().texture = {world_.texts().add("assets/kept.png")};
    for (auto [entity, sprite] : world_.query<const Sprite>()) {
        if (sprite.texture.path == textId("assets/a.png")) entity.addComponent<Persistent>();
    }

    go(kTwo, kOne);

    EXPECT_TRUE(isLoaded("a.png") && isLoaded("kept.png"));
    own.destroy();
    held_.follow(world_, types_);
    assets_.unloadUnused();
    EXPECT_FALSE(isLoaded("kept.png"));
}

TEST_F(SceneAssetsTest, missingAssetsAreReportedOnceAndLoadedWhenTheFileAppears) {
    write("scenes/two.scene.json", scene({sprite("nowhere")}));
    go(kTwo, "");
    EXPECT_EQ(assets_.errors().size(), 1u);
    held_.follow(world_, types_);
    EXPECT_EQ(assets_.errors().size(), 1u);
    EXPECT_TRUE(assets_.isMissing(AssetKind::Texture, textId("assets/nowhere.png")));
}

TEST_F(SceneAssetsTest, aReloadedAssetHasANewRevision) {
    go(kOne, "");
    const std::uint32_t before = assets_.revisionOf(AssetKind::Texture, textId("assets/a.png"));
    go(kTwo, kOne);
    EXPECT_EQ(assets_.revisionOf(AssetKind::Texture, textId("assets/a.png")), 0u);
    go(kOne, kTwo);
    EXPECT_GT(assets_.revisionOf(AssetKind::Texture, textId("assets/a.png")), before);
}

}  // namespace
}  // namespace plumb
