#pragma once

#include <string_view>

#include "core/text_store.hpp"
#include "ecs/world.hpp"

namespace plumb {

/// A frame with an event began, e.g. "step" when a foot comes down.
struct AnimationFrameBegan {
    EntityId entity;
    TextId event;
};

/// Plays every Animator on its entity's Sprite. Reads Animator, writes Animator and Sprite, tells
/// AnimationFrameBegan; after what sets the state machine's parameters.
struct AnimationSystem {
    static constexpr std::string_view kName = "animation";

    void update(World& world, float dt);  ///< dt in s
};

}  // namespace plumb
