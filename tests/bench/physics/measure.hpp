#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/physics/scene_error.hpp"
#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

/// A way to simulate scenes.
struct Engine {
    std::string name;
    int maxThreads = 1;
    bool profiles = false;  ///< tells its stages when asked, at the cost of some time
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
    int lostAfter = 0;       ///< steps, where it was pointless to go on, see isLost(); else 0
    std::string missing;     ///< what the engine lacks for this scene; the rest is then empty
    double msPerStep = 0.0;  ///< total of the best run over its steps, without its first step
    double quietMs = 0.0;    ///< the same of the best of each step over all runs
    double medianMs = 0.0;   ///< of the best of each step
    double firstMs = 0.0;    ///< the first step, which makes what later ones keep
    std::size_t bodies = 0;  ///< at the end
    double contacts = 0.0;   ///< pairs of shapes near each other, mean
    std::size_t lastContacts = 0;
    SceneError error;                   ///< each the mean of several moments of the second half
    std::vector<Profile::Zone> stages;  ///< ms per step
};

struct MeasureOptions {
    int steps = 0;  ///< 0 for what the scene says
    int runs = 3;
    double patience = 30.0;  ///< s for each contender and scene; a slower one runs once
    bool stages = true;      ///< one run more for each engine that has to be asked for its stages
    bool loud = true;        ///< says on stderr what runs
};

/// Runs a scene with all contenders in turn, several times, so that whatever else the machine does meets
/// them all alike.
std::vector<Measurement> measure(const Scene& scene, std::span<const Contender> contenders,
                                 const MeasureOptions& options);

}  // namespace plumb::scenes
