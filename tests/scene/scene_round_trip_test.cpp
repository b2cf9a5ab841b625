#include <cstdlib>

#include <gtest/gtest.h>

#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"
#include "tests/support/random_world.hpp"

namespace plumb {
namespace {

struct SceneRoundTrip : testing::Test {
    TypeRegistry types;
    PrefabLibrary prefabs{types};
    SceneContext context{types, &prefabs};

    SceneRoundTrip() { registerSceneComponents(types); }
};

/// Number of random worlds in the property test: the environment variable PLUMB_WORLDS if set. Debug builds
/// are slow and use fewer.
std::uint64_t worldCount() {
#if defined(NDEBUG)
    constexpr std::uint64_t kUsual = 10000;
#else
    constexpr std::uint64_t kUsual = 1000;
#endif
    const char* wanted = std::getenv("PLUMB_WORLDS");
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : kUsual;
}

TEST_F(SceneRoundTrip, propertyRandomWorldsSurviveJsonAndBinaryByteForByte) {
    World made{types};
    World fromText{types};
    World fromBinary{types};
    for (std::uint64_t seed = 1; seed <= worldCount(); ++seed) {
        SCOPED_TRACE(seed);
        const SceneId scene =
            addRandomScene(made, types, seed, 1 + static_cast<std::uint32_t>(seed % 4), seed % 16 == 0);
        const std::string text = sceneToJson(made, context, scene);

        const auto first = loadScene(fromText, context, "scenes/random.scene.json", text);
        ASSERT_TRUE(first) << first.error().text() << text;
        ASSERT_TRUE(first->problems.empty()) << first->problems.front().text() << text;
        const std::string binary = sceneToBinary(fromText, context, scene);

        const auto second = loadSceneBinary(fromBinary, context, "scenes/random.scene.json", binary);
        ASSERT_TRUE(second) << second.error().text();
        ASSERT_TRUE(second->problems.empty()) << second->problems.front().text();
        ASSERT_EQ(sceneToJson(fromBinary, context, scene), text);
        for (World* world : {&made, &fromText, &fromBinary}) {
            unloadScene(*world, scene);
            world->clear();
        }
    }
}

TEST_F(SceneRoundTrip, everyComponentOfTheRegistryIsInARandomWorldWithAll) {
    World world{types};
    const SceneId scene = addRandomScene(world, types, 16, 2, true);
    const std::string text = sceneToJson(world, context, scene);

    for (const TypeInfo& type : types.all()) {
        if (type.name == "SceneEntity" || type.name == "Name" || startsWith(type.name, "Prefab")) continue;
        EXPECT_NE(text.find("\"" + std::string{type.name} + "\": {"), std::string::npos) << type.name;
    }
}

}  // namespace
}  // namespace plumb
