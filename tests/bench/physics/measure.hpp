#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/physics/scene_error.hpp"
#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

/// A physics engine.
struct Engine {
    std::string name;
    int maxThreads = 1;
    bool profiles = false;  ///< reports its stages on request, at the cost of some time
    std::unique_ptr<SceneBuilder> (*open)(const WorldSetup& setup) = nullptr;
};

/// An engine with a number of threads.
struct Contender {
    const Engine* engine = nullptr;
    int threads = 1;
};

struct Measurement {
    std::string scene;
    std::string engine;
    int threads = 1;
    int size = 0;            ///< of the scene
    int steps = 0;           ///< measured
    int lostAfter = 0;       ///< number of steps after which the run was aborted, see isLost(); else 0
    std::string missing;     ///< feature that the engine lacks for this scene; the rest is then empty
    double msPerStep = 0.0;  ///< total of the best run over its steps, without its first step
    double quietMs = 0.0;    ///< the same, from the minimum of each step over all runs
    double medianMs = 0.0;   ///< median of these minimums
    double firstMs = 0.0;    ///< the first step, which sets up data that later ones keep
    std::size_t bodies = 0;  ///< at the end
    double contacts = 0.0;   ///< pairs of shapes near each other, mean
    std::size_t lastContacts = 0;
    SceneError error;                   ///< each averaged over several samples of the second half
    std::vector<Profile::Zone> stages;  ///< ms per step
};

struct MeasureOptions {
    int steps = 0;  ///< 0: as the scene defines
    int runs = 3;
    double patience = 30.0;  ///< s for each contender and scene; a slower one runs once
    bool stages = true;      ///< one additional run for each engine that reports stages only on request
    bool loud = true;        ///< reports progress on stderr
};

/// Runs a scene with all contenders in turn, several times,
/// so that other work of the machine affects them all alike.
std::vector<Measurement> measure(const Scene& scene, std::span<const Contender> contenders,
                                 const MeasureOptions& options);

}  // namespace plumb::scenes
