#pragma once

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// Connects two bodies. See JointDefinition for the members that each kind uses.
/// @error a dead body, a body connected to itself, two bodies that are not dynamic, numbers out of range
Result<JointId> createJoint(World& world, const JointDefinition& definition);

/// Destroys a joint and wakes its bodies. A stale id does nothing.
void destroyJoint(World& world, JointId joint);

[[nodiscard]] bool alive(const World& world, JointId joint);

/// True when a joint prevents the two bodies from colliding.
[[nodiscard]] bool keptApart(const World& world, std::uint32_t bodyA, std::uint32_t bodyB);

/// The force (N, on B) and the torque (N m) that held the joint in the last step.
[[nodiscard]] Vec2 jointForce(const World& world, JointId joint);
[[nodiscard]] float jointTorque(const World& world, JointId joint);

Result<Done> setMotorSpeed(World& world, JointId joint, float speed);       ///< rad/s or m/s
Result<Done> setTarget(World& world, JointId joint, WorldPosition target);  ///< m, of a Mouse joint

}  // namespace plumb::physics
