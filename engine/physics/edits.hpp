#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Functions shared by the creation, destruction and edits of objects.

template <class Act>
void forShapesOf(const World& world, std::uint32_t body, Act&& act) {
    for (auto s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next) act(s);
}

/// Calls act(contact) for all contacts of the world, sleeping ones last.
template <class Act>
void forContacts(const World& world, Act&& act) {
    for (const Contact& contact : world.contacts) act(contact);
    for (const SleepingIsland& island : world.sleepers.islands) {
        for (std::uint32_t c = island.firstContact; c != kNone; c = world.sleepers.nextContact[c])
            act(world.sleepers.contacts[c]);
    }
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

/// Adds `times` (may be negative) to the numbers of users in World::manifest of the effects of a body/shape.
void countEffectsOfBody(World& world, std::uint32_t body, int times);
void countEffectsOfShape(World& world, std::uint32_t shape, int times);

/// True if a joint of this kind can act on these bodies: one of them is dynamic; for a mouse joint, body B.
constexpr bool canActOn(JointKind kind, BodyKind a, BodyKind b) {
    return b == BodyKind::Dynamic || (a == BodyKind::Dynamic && kind != JointKind::Mouse);
}

/// The bodies that a joint moves: the dynamic ones, except body A of a mouse joint.
struct PushedBodies {
    std::uint32_t a;  ///< kNone if the joint moves only one body
    std::uint32_t b;
};
PushedBodies pushedBodies(const World& world, const Joint& joint);

/// Frees the color of a joint. A caller that keeps the joint must set its color to kNoColour, and newJoints.
void releaseColour(World& world, std::uint32_t joint);
/// Merges the islands of the two bodies of a joint, if both are dynamic.
void joinIslandsOf(World& world, const Joint& joint);

inline constexpr float kLightest = 1.0e-12f;  ///< kg: minimum mass of a dynamic body

/// Computes mass, centre of mass, inertia and extent of a body from its shapes. A dynamic body whose shapes
/// have no mass gets 1 kg and cannot rotate. The shapes do not move; the velocity becomes that of the new
/// centre of mass. Anchors of joints and contact points stay fixed to the shapes.
void updateMass(World& world, std::uint32_t body);
/// Sets the center of mass (m, in the frame of the shapes), without moving the shapes.
void moveCentre(World& world, std::uint32_t body, Vec2 centre);

}  // namespace plumb::physics
