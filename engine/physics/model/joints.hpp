#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Connects two bodies. See JointDefinition for the members that each kind uses.
/// @error a dead body, a body connected to itself, two bodies that are not dynamic, numbers out of range
Result<JointId> createJoint(World& world, const JointDefinition& definition);

/// Destroys a joint, with the gears that it is a part of, and wakes its bodies. A stale id does nothing.
void destroyJoint(World& world, JointId joint);

/// Returns a default definition for a joint that is gone.
[[nodiscard]] inline const JointDefinition& definitionOf(const World& world, JointId joint) {
    return readOf(world, world.joints.definition, joint);
}
/// Changes a joint as if it had been created with the new definition, and wakes its bodies.
/// Its kind, bodies and geared joints must stay the same. See also change() in shapes.hpp.
Result<Done> setDefinition(World& world, JointId joint, const JointDefinition& definition);

/// True when a joint prevents the two bodies from colliding.
[[nodiscard]] bool keptApart(const World& world, std::uint32_t bodyA, std::uint32_t bodyB);

/// The current state of a joint.
struct JointReading {
    float value = 0.0f;       ///< rad: angle; m: length of Distance, translation of Prismatic and Wheel
    float speed = 0.0f;       ///< rad/s or m/s: of that value
    float motorForce = 0.0f;  ///< N m or N, in the last step
    float separation =
        0.0f;  ///< m: error of what it holds, limits included; of Mouse: distance to the target
    float angularSeparation = 0.0f;  ///< rad: the same for its angle
};
/// All 0 for a Filter, and for a joint that is gone.
[[nodiscard]] JointReading readingOf(const World& world, JointId joint);

/// The force (N, on B) and the torque (N m) that held the joint in the last step.
[[nodiscard]] inline Vec2 jointForce(const World& world, JointId joint) {
    return readOf(world, world.joints.hot, joint).force;
}
[[nodiscard]] inline float jointTorque(const World& world, JointId joint) {
    return readOf(world, world.joints.hot, joint).torque;
}

/// @error a joint of a kind without a motor, or without a target
Result<Done> setMotorSpeed(World& world, JointId joint, float speed);       ///< rad/s or m/s
Result<Done> setTarget(World& world, JointId joint, WorldPosition target);  ///< m, of a Mouse joint

}  // namespace plumb::physics
