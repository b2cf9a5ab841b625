#pragma once

#include <array>

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

/// A figure of eleven bodies and ten hinges with limits, springs and friction; 1.55 m tall.
struct Ragdoll {
    std::array<BodyHandle, 11> bodies;
};

/// @param feet    where it stands
/// @param group   below 0; two of one group pass through each other, so that it does not hit itself
Ragdoll addRagdoll(SceneBuilder& world, Vec2 feet, int group);
void removeRagdoll(SceneBuilder& world, const Ragdoll& ragdoll);

}  // namespace plumb::scenes
