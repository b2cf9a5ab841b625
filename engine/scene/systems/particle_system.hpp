#pragma once

#include <string_view>
#include <vector>

#include "ecs/world.hpp"

namespace plumb {

/// Moves and sends the particles of all emitters. Reads ParticleEmitter, Transform and the gravity of the
/// scene, writes the resource Particles; after all that moves entities. Without an emitter nothing is made.
struct ParticleSystem {
    static constexpr std::string_view kName = "particles";

    void update(World& world, float dt);  ///< dt in s

private:
    std::vector<EntityId> emitters_;  // of this tick; kept for its memory
};

}  // namespace plumb
