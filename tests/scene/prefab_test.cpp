#include "scene/files/prefab.hpp"

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/files/world_field_context.hpp"
#include "scene/register_components.hpp"

namespace plumb {
namespace {

constexpr const char* kPath = "scenes/level.scene.json";

/// Two prefabs: a lamp with a bulb that references it, and a post with two lamps, one of them smaller.
struct Prefabs : testing::Test {
    TypeRegistry types;
    PrefabLibrary library{types};
    SceneContext context{types, &library};
    World world{types};

    Prefabs() {
        registerSceneComponents(types);
        library.add("prefabs/lamp.prefab.json", R"({"format": 1, "entities": [
            {"id": "10", "name": "lamp", "components": {"Transform": {"position": [0, 4]}, "Sprite": {"width": 8, "height": 24}}},
            {"id": "11", "name": "bulb", "parent": "10", "components": {"Transform": {}, "Camera": {"follow": "10"}}}]})");
        library.add("prefabs/post.prefab.json", R"({"format": 1, "entities": [
            {"id": "20", "name": "post", "components": {"Transform": {}}},
            {"id": "21", "parent": "20", "prefab": "prefabs/lamp.prefab.json"},
            {"id": "22", "parent": "20", "prefab": "prefabs/lamp.prefab.json", "without": ["Sprite"],
             "children": {"0000000000000011": {"name": "small bulb"}}}]})");
    }

    static std::string sceneOf(const std::string& entities) {
        return "{\n  \"format\": 1,\n  \"effects\": {},\n  \"layers\": [],\n  \"entities\": [\n" + entities +
               "\n  ]\n}\n";
    }
    void load(const std::string& text) {
        const auto report = loadScene(world, context, kPath, text);
        ASSERT_TRUE(report) << report.error().text();
        for (const Error& problem : report->problems) ADD_FAILURE() << problem.text();
    }
    std::string saved() { return sceneToJson(world, context, sceneId(kPath)); }
};

constexpr const char* kPlainLamp = R"(    {
      "id": "00000000000000a1",
      "prefab": "prefabs/lamp.prefab.json",
      "components": {
        "Transform": {
          "position": [0, 4]
        }
      }
    })";

TEST_F(Prefabs, anInstanceHasAllPartsAndSavesOnlyItsPosition) {
    load(sceneOf(R"(    {
      "id": "00000000000000a1",
      "prefab": "prefabs/lamp.prefab.json"
    })"));

    const Entity lamp = findById(world, 0xa1);
    EXPECT_EQ(lamp.get<Sprite>().height, 24);
    const Entity bulb = findById(world, combinedId(0xa1, 0x11));
    ASSERT_TRUE(bulb);
    EXPECT_EQ(parentOf(world, bulb), lamp);
    EXPECT_EQ(bulb.get<Camera>().follow, lamp.id());
    EXPECT_EQ(saved(), sceneOf(kPlainLamp));
}

TEST_F(Prefabs, onlyWhatDiffersFromThePrefabIsSaved) {
    load(sceneOf(kPlainLamp));
    findById(world, 0xa1).get<Transform>().position = {0.0f, 9.0f};
    findById(world, 0xa1).get<Sprite>().height = 24;
    findById(world, combinedId(0xa1, 0x11)).get<Transform>().rotation = 0.5f;

    const std::string expected = sceneOf(R"(    {
      "id": "00000000000000a1",
      "prefab": "prefabs/lamp.prefab.json",
      "components": {
        "Transform": {
          "position": [0, 9]
        }
      },
      "children": {
        "0000000000000011": {
          "components": {
            "Transform": {
              "rotation": 0.5
            }
          }
        }
      }
    })");
    EXPECT_EQ(saved(), expected);
    World again{types};
    ASSERT_TRUE(loadScene(again, context, kPath, expected));
    EXPECT_EQ(sceneToJson(again, context, sceneId(kPath)), expected);
    EXPECT_EQ(findById(again, 0xa1).get<Transform>().position, (Vec2{0.0f, 9.0f}));
}

TEST_F(Prefabs, aValueSetBackToTheTypesDefaultIsAnOverrideToo) {
    load(sceneOf(kPlainLamp));
    findById(world, 0xa1).get<Sprite>().width = Sprite{}.width;

    EXPECT_NE(saved().find("\"width\": 32"), std::string::npos) << saved();
}

TEST_F(Prefabs, removedComponentsAndRemovedPartsStayRemoved) {
    load(sceneOf(kPlainLamp));
    findById(world, 0xa1).removeComponent<Sprite>();
    findById(world, combinedId(0xa1, 0x11)).destroy();
    const std::string text = saved();

    World again{types};
    ASSERT_TRUE(loadScene(again, context, kPath, text));
    EXPECT_FALSE(findById(again, 0xa1).hasComponent<Sprite>());
    EXPECT_FALSE(findById(again, combinedId(0xa1, 0x11)));
    EXPECT_EQ(sceneToJson(again, context, sceneId(kPath)), text);
}

TEST_F(Prefabs, prefabsInsidePrefabsKeepTheirOverrides) {
    load(sceneOf(R"(    {
      "id": "00000000000000b1",
      "prefab": "prefabs/post.prefab.json"
    })"));

    EXPECT_EQ(world.entityCount(), 5u);
    const Entity second = findById(world, combinedId(0xb1, 0x22));
    ASSERT_TRUE(second);
    EXPECT_FALSE(second.hasComponent<Sprite>());
    const Entity bulb = findById(world, combinedId(0xb1, combinedId(0x22, 0x11)));
    ASSERT_TRUE(bulb);
    EXPECT_EQ(world.texts().find(bulb.get<Name>().text), "small bulb");
    EXPECT_EQ(bulb.get<Camera>().follow, second.id());
    EXPECT_EQ(parentOf(world, second), findById(world, 0xb1));
}

TEST_F(Prefabs, entitiesOfTheSceneMayBeChildrenOfAnInstance) {
    const std::string text = sceneOf(std::string{kPlainLamp} + R"(,
    {
      "id": "00000000000000a2",
      "parent": "00000000000000a1",
      "components": {
        "Transform": {
          "position": [0, 0]
        }
      }
    })");
    load(text);

    EXPECT_EQ(parentOf(world, findById(world, 0xa2)), findById(world, 0xa1));
    EXPECT_EQ(saved(), text);
}

TEST_F(Prefabs, twoInstancesHaveDifferentPartsWithLastingIds) {
    load(sceneOf(std::string{kPlainLamp} + R"(,
    {
      "id": "00000000000000a2",
      "prefab": "prefabs/lamp.prefab.json"
    })"));

    EXPECT_NE(combinedId(0xa1, 0x11), combinedId(0xa2, 0x11));
    EXPECT_TRUE(findById(world, combinedId(0xa1, 0x11)));
    EXPECT_TRUE(findById(world, combinedId(0xa2, 0x11)));
}

TEST_F(Prefabs, changesOfAPrefabAffectAllInstancesWithoutAnOverride) {
    load(sceneOf(kPlainLamp));
    findById(world, 0xa1).get<Sprite>().width = 10;
    const std::string text = saved();
    library.add(
        "prefabs/lamp.prefab.json",
        R"({"format": 1, "entities": [{"id": "10", "components": {"Sprite": {"width": 99, "height": 77}}}]})");

    World again{types};
    ASSERT_TRUE(loadScene(again, context, kPath, text));
    EXPECT_EQ(findById(again, 0xa1).get<Sprite>().width, 10);
    EXPECT_EQ(findById(again, 0xa1).get<Sprite>().height, 77);
}

TEST_F(Prefabs, theGameSpawnsThemWithoutSavingThem) {
    addScene(world, kPath);
    const auto lamp = library.find("prefabs/lamp.prefab.json");
    ASSERT_TRUE(lamp);
    const Entity spawned = spawnPrefab(world, types, **lamp, {7.0f, 8.0f});

    EXPECT_EQ(spawned.get<Transform>().position, (Vec2{7.0f, 8.0f}));
    EXPECT_EQ(spawned.get<Transform>().previousPosition, (Vec2{7.0f, 8.0f}));
    EXPECT_EQ(childrenOf(world, spawned).size(), 1u);
    EXPECT_NE(saved().find("\"entities\": []"), std::string::npos);
}

TEST_F(Prefabs, idsOfPartsDoNotCollide) {
    std::vector<std::uint64_t> ids;
    Random random = Random::seeded(5);
    for (int i = 0; i < 2000; ++i)
        ids.push_back(combinedId(random.next64(), 1 + static_cast<std::uint64_t>(i % 50)));
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

}  // namespace
}  // namespace plumb
