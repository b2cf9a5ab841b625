#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

inline constexpr float kStep = 1.0f / 60.0f;  ///< s

/// Callback of a scene before step number `step`, the first being 0.
using BeforeStep = std::function<void(SceneBuilder&, int step)>;

enum class SceneGroup : std::uint8_t {
    Reference,   ///< the ten scenes for which leading engines publish figures
    Comparison,  ///< supported by older engines
    Scaling      ///< the same with 10 to 100,000 bodies
};

struct Scene {
    std::string name;
    SceneGroup group = SceneGroup::Reference;
    int steps = 0;
    Vec2 gravity{0.0f, -10.0f};  ///< m/s2
    bool sleeping = true;
    int warmUp = 0;  ///< steps before those that are measured
    int batch = 1;   ///< steps between two clock reads, because a short step is below its resolution
    int size = 0;    ///< the argument of `build`; the number of bodies in scenes that scale
    /// Fills the empty world. The returned callback may be empty.
    BeforeStep (*build)(SceneBuilder& world, int size) = nullptr;
    /// 2^quality substeps for engines with this parameter; the others use their defaults.
    int quality = 2;
};

/// All scenes, in the order in which they are reported.
std::span<const Scene> allScenes();
const Scene* findScene(std::string_view name);

// The builders: a scene or a few related ones per file, one row each in scenes.cpp.

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
