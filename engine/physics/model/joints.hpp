#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Connects two bodies. See JointDefinition for the members that each kind uses.
/// @error a stale body id, the same body twice, two bodies that are not dynamic, numbers out of range
Result<JointId> createJoint(World& world, const JointDefinition& definition);

/// Destroys a joint and the gears that use it, and wakes its bodies. A stale id does nothing.
void destroyJoint(World& world, JointId joint);

/// Returns the definition of a joint, or the default if it was destroyed.
[[nodiscard]] inline const JointDefinition& definitionOf(const World& world, JointId joint) {
    return readOf(world, world.joints.definition, joint);
}
/// Changes a joint as if it had been created with the new definition, and wakes its bodies. Its kind, its
/// bodies and the joints of a gear cannot change. See also change() in shapes.hpp.
Result<Done> setDefinition(World& world, JointId joint, const JointDefinition& definition);

/// True if a joint prevents the two bodies from colliding.
[[nodiscard]] bool keptApart(const World& world, std::uint32_t bodyA, std::uint32_t bodyB);

/// The current state of a joint.
struct JointReading {
    float value = 0.0f;       ///< rad: angle; m: length of Distance, translation of Prismatic and Wheel
    float speed = 0.0f;       ///< rad/s or m/s: rate of change of `value`
    float motorForce = 0.0f;  ///< N m or N, in the last substep of the last step
    float separation = 0.0f;  ///< m: error of its constraints and limits; Mouse: distance to the target
    float angularSeparation = 0.0f;  ///< rad: error of its angle
};
/// Returns the current state of a joint; all 0 for a Filter and for a destroyed joint.
[[nodiscard]] JointReading readingOf(const World& world, JointId joint);

/// Return the constraint force (N, on B) and torque (N m) of a joint in the last substep.
[[nodiscard]] inline Vec2 jointForce(const World& world, JointId joint) {
    return readOf(world, world.joints.hot, joint).force;
}
[[nodiscard]] inline float jointTorque(const World& world, JointId joint) {
    return readOf(world, world.joints.hot, joint).torque;
}

/// @error a kind of joint without a motor (setMotorSpeed) or a target (setTarget)
Result<Done> setMotorSpeed(World& world, JointId joint, float speed);       ///< rad/s or m/s
Result<Done> setTarget(World& world, JointId joint, WorldPosition target);  ///< m, of a Mouse joint

}  // namespace plumb::physics
