#pragma once

#include <array>

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::scenes {

/// A ragdoll of eleven bodies and ten hinges with limits, springs and friction; 1.55 m tall.
struct Ragdoll {
    std::array<BodyHandle, 11> bodies;
};

/// Adds a ragdoll.
/// @param feet    position of its feet, m
/// @param group   collision group, negative: bodies of the same group do not collide with each other
Ragdoll addRagdoll(SceneBuilder& world, Vec2 feet, int group);
void removeRagdoll(SceneBuilder& world, const Ragdoll& ragdoll);

}  // namespace plumb::scenes
