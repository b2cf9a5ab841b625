#pragma once

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// Ties two bodies together. See JointDefinition for what each kind takes.
/// @error a dead body, a body tied to itself, two bodies that cannot be pushed, numbers out of range
Result<JointId> createJoint(World& world, const JointDefinition& definition);

/// Removes a joint and wakes its bodies. A stale id does nothing.
void destroyJoint(World& world, JointId joint);

[[nodiscard]] bool alive(const World& world, JointId joint);

/// True when a joint keeps the two bodies from meeting.
[[nodiscard]] bool keptApart(const World& world, std::uint32_t bodyA, std::uint32_t bodyB);

/// What the joint needed in the last step to hold: N on B, and N m.
[[nodiscard]] Vec2 jointForce(const World& world, JointId joint);
[[nodiscard]] float jointTorque(const World& world, JointId joint);

Result<Done> setMotorSpeed(World& world, JointId joint, float speed);  ///< rad/s or m/s
Result<Done> setTarget(World& world, JointId joint, Place target);     ///< m, of Mouse

}  // namespace plumb::physics
