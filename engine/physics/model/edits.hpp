#pragma once

#include <cstdint>

#include "physics/world.hpp"

namespace plumb::physics {

// Parts of creation and destruction that changes of a living object repeat.

template <class Act>
void forShapesOf(const World& world, std::uint32_t body, Act&& act) {
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next)
        act(s);
}

template <class Act>
void forJointsOf(const World& world, std::uint32_t body, Act&& act) {
    for (std::uint32_t j = world.bodies.info[body].firstJoint; j != kNone;) {
        const Joint& joint = world.joints.hot[j];
        const std::uint32_t next = joint.bodyA == body ? joint.nextA : joint.nextB;
        act(j);
        j = next;
    }
}

/// Counts a body, without its shapes, as a user of the effects that it needs; a negative `times` removes it.
void countEffectsOfBody(World& world, std::uint32_t body, int times);
void countEffectsOfShape(World& world, std::uint32_t shape, int times);

/// Its bodies no longer have the color of the joint. A joint that stays gets kNoColour and World::newJoints.
void releaseColour(World& world, std::uint32_t joint);
/// One island for both bodies of a joint, if both are dynamic.
void joinIslandsOf(World& world, const Joint& joint);

}  // namespace plumb::physics
