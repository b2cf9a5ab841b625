#pragma once

#include <string_view>
#include <vector>

#include "ecs/world.hpp"

namespace plumb {

/// Emits and moves the particles of all emitters. Does not create the Particles resource without an emitter.
/// Reads: ParticleEmitter, Transform, gravity of the scene. Writes: Particles.
/// When: after all systems that move entities.
struct ParticleSystem {
    static constexpr std::string_view kName = "particles";

    void update(World& world, float dt);  ///< dt in s

private:
    std::vector<EntityId> emitters_;  // emitters in this tick; a member, so that its memory is reused
};

}  // namespace plumb
