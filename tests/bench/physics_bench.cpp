// Benchmark of the physics library and of other physics engines that are installed.

#include "tests/bench/bench.hpp"
#include "tests/bench/physics/contest.hpp"
#include "tests/bench/physics/peers/peers.hpp"
#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::bench {

int runPhysics(const Options& options) {
    scenes::ContestOptions contest{.jsonPath = options.jsonPath, .quick = options.quick};
    if (!scenes::readOptions(options.rest, contest)) return 2;
    std::vector<scenes::Engine> engines{scenes::plumbEngine()};
    for (scenes::Engine& peer : scenes::peerEngines()) engines.push_back(std::move(peer));
    return scenes::runContest(engines, contest);
}

}  // namespace plumb::bench
