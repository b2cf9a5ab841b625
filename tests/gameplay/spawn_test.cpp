#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "core/log.hpp"
#include "ecs/world.hpp"
#include "gameplay/game_functions.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab.hpp"
#include "scene/register_components.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

class Spawning : public testing::Test {
protected:
    Spawning() {
        registerSceneComponents(types);
        assets.logging = false;
        world.provide(assets);
        world.provide(library);
        before_ = setLogSink([this](const LogLine& line) { log.push_back(line.text); });
    }
    ~Spawning() override { setLogSink(before_); }

    void put(const std::string& path, const std::string& components) {
        ASSERT_TRUE(writeFile(folder.path / path,
                              R"({"format": 1, "entities": [{"id": "1", "components": )" + components + "}]}")
                        .ok());
    }

    test::TemporaryFolder folder;
    TypeRegistry types;
    World world{types};
    AssetStore assets{folder.path};
    PrefabLibrary library{types, folder.path};
    std::vector<std::string> log;

private:
    LogSink before_;
};

TEST_F(Spawning, everyFormOfTheNameIsTheSamePrefab) {
    put("prefabs/coin.prefab.json", R"({"Transform": {"position": [9, 9], "rotation": 0.5}})");
    const PrefabId field{world.texts().add("prefabs/coin.prefab.json")};
    for (const Entity coin :
         {spawn(world, "coin", {3, 4}), spawn(world, "coin.prefab.json", {3, 4}),
          spawn(world, "prefabs/coin", {3, 4}), spawn(world, "prefabs/coin.prefab.json", {3, 4}),
          spawn(world, field, {3, 4})}) {
        ASSERT_TRUE(coin);
        EXPECT_EQ(coin.get<Transform>().position, (Vec2{3, 4}));
        EXPECT_FLOAT_EQ(coin.get<Transform>().rotation, 0.5f);
    }
    EXPECT_EQ(world.entityCount(), 5u);
    EXPECT_TRUE(log.empty()) << log.front();
}

TEST_F(Spawning, anEmptyFieldCreatesNothingAndIsNoError) {
    EXPECT_FALSE(spawn(world, PrefabId{}, {}));
    EXPECT_EQ(world.entityCount(), 0u);
    EXPECT_TRUE(log.empty());
}

TEST_F(Spawning, theProblemsOfAPrefabAreLoggedAtTheFirstSpawnOnly) {
    put("prefabs/coin.prefab.json", R"({"Transform": {"positon": [9, 9]}})");
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(spawn(world, i == 1 ? "prefabs/coin" : "coin", {}));
    EXPECT_EQ(log,
              (std::vector<std::string>{
                  "prefabs/coin.prefab.json: entities[0].Transform.positon: Transform has no such field; "
                  "it is kept unchanged; did you mean \"position\"?"}));
}

TEST_F(Spawning, aMissingPrefabIsLoggedOnceWithTheNearestFileAndFoundWhenItAppears) {
    put("prefabs/coin.prefab.json", "{}");
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(spawn(world, "cion", {}));
    EXPECT_EQ(log, (std::vector<std::string>{"prefabs/cion.prefab.json: there is no such file; did you mean "
                                             "\"prefabs/coin.prefab.json\"?"}));
    put("prefabs/cion.prefab.json", "{}");
    EXPECT_TRUE(spawn(world, "cion", {}));
    EXPECT_EQ(log.size(), 1u);
}

TEST_F(Spawning, theFileOfASpawnedPrefabIsWatchedWithThoseOfNestedOnes) {
    put("prefabs/coin.prefab.json", "{}");
    ASSERT_TRUE(writeFile(folder.path / "prefabs/bag.prefab.json",
                          R"({"format": 1, "entities": [{"id": "1"},
                              {"id": "2", "prefab": "prefabs/coin.prefab.json"}]})")
                    .ok());
    ASSERT_TRUE(spawn(world, "bag", {}));
    for (const char* path : {"prefabs/bag.prefab.json", "prefabs/coin.prefab.json"})
        EXPECT_FALSE(assets.isMissing(AssetKind::Prefab, textId(path))) << path;
}

}  // namespace
}  // namespace plumb
