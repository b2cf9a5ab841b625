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
    int size = 0;                  ///< Scene::size
    int steps = 0;                 ///< number of measured steps
    int lostAfter = 0;             ///< number of steps after which the run was aborted, see isLost(); else 0
    std::string missing;           ///< feature that the engine lacks for this scene; the rest is then empty
    double msPerStep = 0.0;        ///< mean time of a step in the fastest run, without its first step
    double quietMs = 0.0;          ///< mean, without the first step, of each step's minimum over all runs
    double medianMs = 0.0;         ///< median over the steps of each step's minimum over all runs
    double firstMs = 0.0;          ///< time of the first step, which creates data that later steps reuse
    std::size_t bodies = 0;        ///< number of bodies at the end
    double contacts = 0.0;         ///< mean number of pairs of shapes near each other
    std::size_t lastContacts = 0;  ///< number of such pairs at the end
    SceneError error;              ///< mean of several samples in the second half of the run
    std::vector<Profile::Zone> stages;  ///< ms per step
};

struct MeasureOptions {
    int steps = 0;  ///< maximum number of steps; 0: as the scene defines
    int runs = 3;
    double patience = 30.0;  ///< s per contender and scene; afterwards no further run is started
    bool stages = true;      ///< one additional run for each engine that reports stages only on request
    bool loud = true;        ///< reports progress on stderr
};

/// Runs a scene with all contenders alternately, several times,
/// so that other work of the machine affects all equally.
std::vector<Measurement> measure(const Scene& scene, std::span<const Contender> contenders,
                                 const MeasureOptions& options);

}  // namespace plumb::scenes
