#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/prefab.hpp"
#include "scene/register_components.hpp"

namespace plumb {
namespace {

constexpr const char* kBullet = R"({
  "format": 1,
  "entities": [
    { "id": "0000000000000001", "name": "bullet",
      "components": { "Transform": {}, "Sprite": { "texture": "bullet.png" }, "Animator": { "animation": "fly.anim.json" } } },
    { "id": "0000000000000002", "name": "glow", "parent": "0000000000000001",
      "components": { "Transform": {}, "Sprite": { "texture": "bullet.png" } } }
  ]
})";

TEST(PrefabAssets, areNamedOnce) {
    TypeRegistry types;
    registerSceneComponents(types);
    PrefabLibrary prefabs{types};
    prefabs.add("bullet.prefab.json", kBullet);
    const Result<const Prefab*> prefab = prefabs.find("bullet.prefab.json");
    ASSERT_TRUE(prefab.ok()) << prefab.error().text();
    EXPECT_EQ((*prefab)->assets, (std::vector<PrefabAsset>{{AssetKind::Texture, "bullet.png"},
                                                           {AssetKind::Animation, "fly.anim.json"}}));
}

TEST(PrefabAssets, areLoadedWhenThePrefabIsSpawned) {
    TypeRegistry types;
    registerSceneComponents(types);
    PrefabLibrary prefabs{types};
    prefabs.add("bullet.prefab.json", kBullet);
    World world{types};
    AssetStore assets;
    assets.logging = false;
    world.provide(assets);
    ASSERT_EQ(assets.size(), 0u);
    const Result<const Prefab*> prefab = prefabs.find("bullet.prefab.json");
    ASSERT_TRUE(prefab.ok());
    spawnPrefab(world, types, **prefab, {});
    EXPECT_TRUE(assets.isMissing(AssetKind::Texture, textId("bullet.png"))) << "looked for, and reported";
    EXPECT_EQ(assets.errors().size(), 2u);
}

}  // namespace
}  // namespace plumb
