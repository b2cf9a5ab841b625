#pragma once

#include <vector>

#include "tests/bench/physics/measure.hpp"

namespace plumb::scenes {

/// Returns the other engines that were installed on this machine at build time.
std::vector<Engine> peerEngines();

Engine box2dEngine();         ///< Box2D 2.4, 8 velocity and 3 position iterations
Engine box2dUnsweptEngine();  ///< Box2D 2.4 without continuous collision
Engine chipmunkEngine();      ///< Chipmunk 7, 10 iterations

}  // namespace plumb::scenes
