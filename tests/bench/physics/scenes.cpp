#include "tests/bench/physics/scenes.hpp"

#include <algorithm>
#include <vector>

namespace plumb::scenes {

namespace {

using enum SceneGroup;

constexpr Vec2 kDown{0.0f, -10.0f};
constexpr bool kSleeps = true;
constexpr bool kWakes = false;

/// Adds a family of scenes with 10 to 100,000 falling bodies, each simulated for two seconds.
void addScaling(std::vector<Scene>& scenes, const std::string& family, decltype(Scene::build) build) {
    constexpr int kSteps = 120;
    for (const int size : {10, 100, 1000, 10000, 100000}) {
        const int batch = size <= 10 ? 10 : size <= 100 ? 4 : 1;
        scenes.push_back(
            {family + "_" + std::to_string(size), Scaling, kSteps, kDown, kWakes, 0, batch, size, build});
    }
}

std::vector<Scene> makeScenes() {
    std::vector<Scene> scenes{
        // With the default quality 2 the largest joint gap is 0.44 m; with 3 it is 0.1 m, in a third more
        // time.
        {"joint_grid", Reference, 500, kDown, kWakes, 0, 1, 100, &buildJointGrid, 3},
        {"large_pyramid", Reference, 500, kDown, kWakes, 0, 1, 100, &buildLargePyramid},
        {"many_pyramids", Reference, 200, kDown, kWakes, 0, 1, 20, &buildManyPyramids},
        {"rain", Reference, 1000, kDown, kSleeps, 0, 1, 40, &buildRain},
        {"smash", Reference, 300, {0.0f, 0.0f}, kSleeps, 0, 1, 120, &buildSmash},
        {"spinner", Reference, 500, kDown, kSleeps, 0, 1, 6076, &buildSpinner},
        {"tumbler", Reference, 750, kDown, kSleeps, 0, 1, 45, &buildTumbler},
        {"washer", Reference, 500, kDown, kSleeps, 0, 1, 90, &buildWasher},
        {"junkyard", Reference, 800, kDown, kSleeps, 0, 1, 40, &buildJunkyard},
        {"compounds", Reference, 500, kDown, kSleeps, 0, 1, 150, &buildCompounds},

        {"pyramid100", Comparison, 500, kDown, kWakes, 0, 1, 100, &buildLargePyramid},
        {"pile5000", Comparison, 600, kDown, kWakes, 0, 1, 5000, &buildPile},
        {"pile500", Comparison, 600, kDown, kWakes, 0, 1, 500, &buildPile},
        {"jointgrid100", Comparison, 500, kDown, kWakes, 0, 1, 100, &buildJointGrid},
        {"stacks200", Comparison, 1000, kDown, kWakes, 0, 4, 200, &buildStacks},
        {"boxes20", Comparison, 2000, kDown, kWakes, 0, 20, 20, &buildBoxes},
        {"sleeping10000", Comparison, 20000, kDown, kSleeps, 90, 200, 10000, &buildSleepers},
    };
    addScaling(scenes, "boxes_uniform", &buildUniformBoxes);
    addScaling(scenes, "boxes_clustered", &buildClusteredBoxes);
    addScaling(scenes, "circles_uniform", &buildUniformCircles);
    addScaling(scenes, "circles_clustered", &buildClusteredCircles);
    return scenes;
}

}  // namespace

std::span<const Scene> allScenes() {
    static const std::vector<Scene> scenes = makeScenes();
    return scenes;
}

const Scene* findScene(std::string_view name) {
    const auto scenes = allScenes();
    const auto found =
        std::find_if(scenes.begin(), scenes.end(), [name](const Scene& scene) { return scene.name == name; });
    return found == scenes.end() ? nullptr : &*found;
}

}  // namespace plumb::scenes
