#include <cstdlib>
#include <deque>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/game.hpp"
#include "app/game_content.hpp"
#include "core/file.hpp"
#include "core/random.hpp"
#include "gameplay/game_progress.hpp"
#include "platform/paths.hpp"
#include "render/recording_device.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_world.hpp"

namespace plumb {
namespace {

constexpr const char* kPath = "scenes/mutated.scene.json";

/// Number of mutations: the environment variable PLUMB_MUTATIONS if set. The full run with sanitizers uses
/// 100,000.
std::uint64_t mutationCount() {
    const char* wanted = std::getenv("PLUMB_MUTATIONS");
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 1000;
}

/// A scene file to damage, and the prefabs that it references.
struct Sample {
    std::string text;
    PrefabLibrary prefabs;
};

struct SceneMutations : testing::Test {
    Game game;
    World again{game.types};
    RecordingDevice device;
    SceneRenderer renderer{device, game.assets};
    std::deque<Sample> samples;

    SceneMutations() {
        const Path projects = test::sourceFolder() / "projects";
        game.assets = AssetStore{projects / "platformer", engineAssets()};
        game.assets.logging = false;
        device.recordsDraws = false;
        game.content.addSystems(game.world);
        for (const std::string& name : filesBelow(projects, ".scene.json")) {
            auto text = readFile(projects / name);
            EXPECT_TRUE(text.ok());
            samples.push_back(
                {std::move(*text), PrefabLibrary{game.types, projects / name.substr(0, name.find('/'))}});
        }
        // One more sample with every component type.
        samples.push_back({{}, PrefabLibrary{game.types}});
        World made{game.types};
        const SceneId scene = addRandomScene(made, game.types, 77, 6, true);
        samples.back().text = sceneToJson(made, contextOf(samples.back()), scene);
    }

    SceneContext contextOf(Sample& sample) const { return {game.types, &sample.prefabs}; }
    Sample& sampleOf(std::uint64_t seed) { return samples[seed % samples.size()]; }

    static void empty(World& used) {
        unloadScene(used, sceneId(kPath));
        used.clear();
    }

    /// Expects that the loaded scene can be written, and that the written file loads to the same scene.
    void expectStable(const SceneContext& context, std::size_t loaded) {
        const std::string saved = sceneToJson(game.world, context, sceneId(kPath));
        const auto second = loadScene(again, context, kPath, saved);
        ASSERT_TRUE(second) << second.error().text() << saved;
        EXPECT_EQ(second->loaded, loaded);
        EXPECT_EQ(sceneToJson(again, context, sceneId(kPath)), saved);
        empty(again);
    }

    /// Plays and draws the loaded scene, whatever its values are.
    void play() {
        loadAssets(game.world, game.types, game.assets);
        game.assets.clearErrors();
        InputFrame frame;
        frame.set(Key::Right, true);
        for (int i = 0; i < 3; ++i) tickGame(game, frame);
        renderer.draw(game.world, {320.0f, 180.0f}, 0.5f, {{}, 0, 0, 640, 360}, &fillPlaceholders);
    }

    void expectFine(const SceneContext& context, const Result<LoadReport>& report) {
        if (report) {
            expectStable(context, report->loaded);
            play();
        } else {
            EXPECT_FALSE(report.error().what.empty());
        }
        empty(game.world);
    }
};

TEST_F(SceneMutations, propertyADamagedSceneIsPlayedInPartOrRefusedAndNothingIsLost) {
    for (std::uint64_t seed = 1; seed <= mutationCount(); ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Sample& sample = sampleOf(seed);
        const SceneContext context = contextOf(sample);
        expectFine(context, loadScene(game.world, context, kPath, test::damaged(sample.text, random)));
        ASSERT_FALSE(HasFailure());
    }
}

TEST_F(SceneMutations, propertyADamagedBinaryIsPlayedInPartOrRefused) {
    std::vector<std::string> binaries;
    for (Sample& sample : samples) {
        ASSERT_TRUE(loadScene(game.world, contextOf(sample), kPath, sample.text));
        binaries.push_back(sceneToBinary(game.world, contextOf(sample), sceneId(kPath)));
        empty(game.world);
    }
    for (std::uint64_t seed = 1; seed <= mutationCount() / 2; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const SceneContext context = contextOf(sampleOf(seed));
        const std::string bytes = test::damaged(binaries[seed % binaries.size()], random);
        expectFine(context, loadSceneBinary(game.world, context, kPath, bytes));
        ASSERT_FALSE(HasFailure());
    }
}

}  // namespace
}  // namespace plumb
