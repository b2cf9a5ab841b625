#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

constexpr bool contains(const AABB& outer, const AABB& inner) {
    return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y && inner.max.x <= outer.max.x &&
           inner.max.y <= outer.max.y;
}
ProxyMotion motionOf(const World& world, std::uint32_t shape);  ///< in which group the broad phase has it

/// Returns the frame of a body's shapes in float, which is accurate near the origin only.
inline Frame frameOf(const BodyPose& pose) {
    return {toVec2(pose.centre) - rotate(pose.rotation, pose.localCentre), pose.rotation};
}

/// Returns the bounding box (m) of the shape in its current pose, without a margin.
AABB tightBounds(const World& world, std::uint32_t shape);

/// Computes the bounds of a new shape and queues it for the broad phase.
void setBounds(World& world, std::uint32_t shape);
/// Calls setBounds() for all shapes of a body that was teleported.
void refreshBounds(World& world, std::uint32_t body);

/// Marks a shape as changed: the next step ends its contacts and finds them again.
void alter(World& world, std::uint32_t shape);

/// Queues an update of the broad phase's copy of the shape.
void noteChanged(World& world, std::uint32_t shape);
/// Makes the broad phase search for pairs of the shape in the next step.
void noteMoved(World& world, std::uint32_t shape);

/// Updates the broad phase with all changes since the last update; refills the workspace after the world was
/// overwritten. Called first in each step and query. When it is called does not affect the result of a step.
void updateBroadPhase(World& world, Workspace& work);

/// Updates the copies of the shape's properties, such as friction, that its contacts store.
void refreshContacts(World& world, std::uint32_t shape);
/// Calls refreshContacts() for all shapes of a body whose rotation, or ability to rotate, changed.
void refreshContactsOf(World& world, std::uint32_t body);

}  // namespace plumb::physics
