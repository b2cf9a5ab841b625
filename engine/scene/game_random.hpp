#pragma once

#include "core/hash.hpp"
#include "core/random.hpp"

namespace plumb {

/// The random numbers of the simulation. A resource, so that a snapshot repeats them; seeded when a game starts.
struct GameRandom {
    Random random;

    void addTo(Hasher& hasher) const { hasher.add(random.state); }
};

}  // namespace plumb
