#pragma once

#include "core/hash.hpp"
#include "core/random.hpp"

namespace plumb {

/// Random number generator of the simulation, seeded when a game
/// starts. A world resource, so that snapshots include its state.
struct GameRandom {
    Random random;

    void addTo(Hasher& hasher) const { hasher.add(random.state); }
};

}  // namespace plumb
