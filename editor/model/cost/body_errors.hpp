#pragma once

#include <vector>

#include "physics/world.hpp"

namespace plumb::editor {

/// Returns the largest overlap or joint gap (m) of each dynamic body, indexed by BodyId::index; 0 for static
/// and kinematic bodies.
std::vector<float> bodyErrors(const physics::World& world);

/// Normal force at one contact point of two bodies.
struct ContactPush {
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;
    physics::WorldPosition place;  ///< m: position of the contact point
    float force = 0.0f;            ///< N, mean over the last substep
    float weights = 0.0f;          ///< force divided by the weight of the lighter body
};
/// Returns all contact points with a force, of awake and sleeping bodies.
std::vector<ContactPush> contactPushes(const physics::World& world);

}  // namespace plumb::editor
