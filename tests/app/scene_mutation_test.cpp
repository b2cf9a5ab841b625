#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/random.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/persistent.hpp"
#include "scene/prefab.hpp"
#include "scene/register_components.hpp"
#include "scene/scene_file.hpp"
#include "tests/support/random_world.hpp"

namespace plumb {
namespace {

constexpr const char* kPath = "scenes/mutated.scene.json";

/// How many mutations are tried; PLUMB_MUTATIONS says so. The full run with sanitizers takes 100,000.
std::uint64_t mutationCount() {
    const char* wanted = std::getenv("PLUMB_MUTATIONS");
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 1000;
}

/// Damages a file as disks, editors and people do.
std::string mutated(std::string bytes, Random& random) {
    static constexpr std::array kTokens{"{",
                                        "}",
                                        "[",
                                        "]",
                                        ",",
                                        "\"",
                                        ":",
                                        "null",
                                        "-1",
                                        "1e999",
                                        "NaN",
                                        "true",
                                        "\"\"",
                                        "{}",
                                        "[]",
                                        "\\",
                                        "\xff",
                                        "99999999999999999999",
                                        "\"id\": \"a1\",",
                                        "\"parent\": \"a1\",",
                                        "\"prefab\": \"x\","};
    const std::uint32_t changes = 1 + random.below(4);
    for (std::uint32_t i = 0; i < changes && !bytes.empty(); ++i) {
        const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
        const std::size_t length = std::min<std::size_t>(1 + random.below(40), bytes.size() - at);
        switch (random.below(6)) {
            case 0: bytes[at] = static_cast<char>(random.next()); break;
            case 1: bytes.erase(at, length); break;
            case 2: bytes.insert(at, bytes.substr(at, length)); break;
            case 3: bytes.insert(at, kTokens[random.below(kTokens.size())]); break;
            case 4:
                bytes.replace(at, std::min<std::size_t>(length, 4), kTokens[random.below(kTokens.size())]);
                break;
            default:
                if (random.below(20) == 0) bytes.resize(at);
                break;
        }
    }
    return bytes;
}

struct SceneMutations : testing::Test {
    TypeRegistry types;
    PrefabLibrary prefabs{types};
    SceneContext context{types, &prefabs};
    World world{types};
    World again{types};

    SceneMutations() { registerSceneComponents(types); }

    static void empty(World& used) {
        unloadScene(used, sceneId(kPath));
        used.clear();
    }

    /// The scenes of all projects, and one of our own with every component.
    std::vector<std::string> samples() {
        std::vector<std::string> texts;
        for (const std::string& name : filesBelow(Path{PLUMB_SOURCE_DIR} / "projects", ".scene.json")) {
            if (auto text = readFile(Path{PLUMB_SOURCE_DIR} / "projects" / name))
                texts.push_back(std::move(*text));
        }
        World made{types};
        texts.push_back(sceneToJson(made, context, addRandomScene(made, types, 77, 6, true)));
        return texts;
    }

    /// What loaded is written, and what was written loads to the same.
    void expectStable(std::size_t loaded) {
        const std::string saved = sceneToJson(world, context, sceneId(kPath));
        const auto second = loadScene(again, context, kPath, saved);
        ASSERT_TRUE(second) << second.error().text() << saved;
        EXPECT_EQ(second->loaded, loaded);
        EXPECT_EQ(sceneToJson(again, context, sceneId(kPath)), saved);
        empty(again);
    }
};

TEST_F(SceneMutations, propertyADamagedSceneLoadsInPartOrIsRefusedAndNothingIsLost) {
    const std::vector<std::string> texts = samples();
    for (std::uint64_t seed = 1; seed <= mutationCount(); ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const std::string text = mutated(texts[seed % texts.size()], random);
        const auto report = loadScene(world, context, kPath, text);
        if (report) {
            expectStable(report->loaded);
        } else {
            EXPECT_FALSE(report.error().what.empty());
        }
        empty(world);
        ASSERT_FALSE(HasFailure());
    }
}

TEST_F(SceneMutations, propertyADamagedBinaryLoadsInPartOrIsRefused) {
    World made{types};
    const std::string bytes = sceneToBinary(made, context, addRandomScene(made, types, 78, 6, true));
    for (std::uint64_t seed = 1; seed <= mutationCount() / 2; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const auto report = loadSceneBinary(world, context, kPath, mutated(bytes, random));
        if (report) expectStable(report->loaded);
        empty(world);
        ASSERT_FALSE(HasFailure());
    }
}

TEST_F(SceneMutations, aHundredSwitchesLeaveNothingBehind) {
    const std::vector<std::string> texts = samples();
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(loadScene(world, context, kPath, texts[static_cast<std::size_t>(i) % texts.size()]));
        EXPECT_GT(world.entityCount(), 0u);
        for (auto [entity, tag] : world.query<const Persistent>()) entity.removeComponent<Persistent>();
        unloadScene(world, sceneId(kPath));
        EXPECT_EQ(world.entityCount(), 0u);
        EXPECT_EQ(world.tiles().size(), 0u);
    }
}

}  // namespace
}  // namespace plumb
