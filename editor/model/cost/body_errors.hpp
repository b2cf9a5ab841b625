#pragma once

#include <vector>

#include "physics/world.hpp"

namespace plumb::editor {

/// m: how far each body, by BodyId::index, is inside of others or away from its joints. Those that cannot be
/// pushed have none: it counts for the body that is pushed.
std::vector<float> bodyErrors(const physics::World& world);

/// Where two shapes push each other, and how hard.
struct ContactPush {
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;
    physics::WorldPosition place;  ///< m
    float force = 0.0f;            ///< N, on the mean of the last substep
    float weights = 0.0f;          ///< ratio: of the weight of the lighter one of the two
};
/// Those that push at present, of bodies that are awake and of those that rest.
std::vector<ContactPush> contactPushes(const physics::World& world);

}  // namespace plumb::editor
