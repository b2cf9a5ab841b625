#pragma once

#include <string_view>

#include "core/text_store.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// Event: an animation frame with an event name started, e.g. "step" when a foot touches the ground.
struct AnimationFrameBegan {
    EntityId entity;
    TextId event;
};

/// Plays every Animator on its entity's Sprite.
/// Reads: Animator. Writes: Animator, Sprite. Emits: AnimationFrameBegan.
/// When: after the systems that set state machine parameters.
struct AnimationSystem {
    static constexpr std::string_view kName = "animation";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
