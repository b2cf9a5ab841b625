#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

inline constexpr float kStep = 1.0f / 60.0f;  ///< s

/// Callback of a scene before each step. `step` is the step's number, beginning with 0.
using BeforeStep = std::function<void(SceneBuilder&, int step)>;

enum class SceneGroup : std::uint8_t {
    Reference,   ///< ten scenes like those for which leading engines publish results
    Comparison,  ///< scenes that older engines can simulate too
    Scaling      ///< families of scenes with 10 to 100,000 bodies
};

struct Scene {
    std::string name;
    SceneGroup group = SceneGroup::Reference;
    int steps = 0;
    Vec2 gravity{0.0f, -10.0f};  ///< m/s2
    bool sleeping = true;
    int warmUp = 0;  ///< number of steps before the measured ones
    int batch = 1;  ///< steps between two clock reads, because one short step is below the clock's resolution
    int size = 0;   ///< argument of `build`; in group Scaling the number of bodies
    /// Fills the empty world. The returned callback may be empty.
    BeforeStep (*build)(SceneBuilder& world, int size) = nullptr;
    /// 2^quality substeps for engines with this parameter; other engines use their defaults.
    int quality = 2;
};

/// All scenes, in the order in which they are reported.
std::span<const Scene> allScenes();
const Scene* findScene(std::string_view name);

// Functions that build the scenes, in *_scene.cpp and *_scenes.cpp; registered in scenes.cpp.

BeforeStep buildJointGrid(SceneBuilder& world, int side);
BeforeStep buildLargePyramid(SceneBuilder& world, int base);
BeforeStep buildManyPyramids(SceneBuilder& world, int side);
BeforeStep buildRain(SceneBuilder& world, int columns);
BeforeStep buildSmash(SceneBuilder& world, int columns);
BeforeStep buildSpinner(SceneBuilder& world, int bodies);
BeforeStep buildTumbler(SceneBuilder& world, int side);
BeforeStep buildWasher(SceneBuilder& world, int side);
BeforeStep buildJunkyard(SceneBuilder& world, int rows);
BeforeStep buildCompounds(SceneBuilder& world, int rows);
BeforeStep buildPile(SceneBuilder& world, int bodies);
BeforeStep buildStacks(SceneBuilder& world, int boxes);
BeforeStep buildBoxes(SceneBuilder& world, int boxes);
BeforeStep buildUniformBoxes(SceneBuilder& world, int bodies);
BeforeStep buildUniformCircles(SceneBuilder& world, int bodies);
BeforeStep buildClusteredBoxes(SceneBuilder& world, int bodies);
BeforeStep buildClusteredCircles(SceneBuilder& world, int bodies);
BeforeStep buildSleepers(SceneBuilder& world, int bodies);

}  // namespace plumb::scenes
