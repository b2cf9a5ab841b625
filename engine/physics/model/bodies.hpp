#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Creates a body without shapes.
/// @error a number that is not finite or out of range, a negative drag
Result<BodyId> createBody(World& world, const BodyDefinition& definition);

/// Destroys a body with its shapes and joints; its contacts end in the next step. A stale id does nothing.
void destroyBody(World& world, BodyId body);

[[nodiscard]] inline std::size_t bodyCount(const World& world) {
    return world.bodies.size() - world.bodies.free.size() - world.bodies.dying.size();
}

// Getters. For a stale id they return defaults: at the origin, at rest, mass 0, neither awake nor enabled.

/// Converts a point (m) from the frame of the body's shapes to the world; localPoint() is the inverse.
/// Positions are subtracted first, so the result is as accurate far from the origin as near it.
[[nodiscard]] inline WorldPosition worldPoint(const BodyPose& pose, Vec2 point) {
    return pose.centre + rotate(pose.rotation, point - pose.localCentre);
}
[[nodiscard]] inline Vec2 localPoint(const BodyPose& pose, WorldPosition point) {
    return pose.localCentre + unrotate(pose.rotation, point - pose.centre);
}
[[nodiscard]] inline WorldPosition worldPoint(const World& world, BodyId body, Vec2 point) {
    return worldPoint(readOf(world, world.bodies.pose, body), point);
}
[[nodiscard]] inline Vec2 localPoint(const World& world, BodyId body, WorldPosition point) {
    return localPoint(readOf(world, world.bodies.pose, body), point);
}
[[nodiscard]] inline WorldPosition positionOf(const World& world, BodyId body) {
    return worldPoint(world, body, {});  ///< m: origin of the frame of its shapes
}
[[nodiscard]] inline WorldPosition centreOf(const World& world, BodyId body) {
    return readOf(world, world.bodies.pose, body).centre;
}
[[nodiscard]] inline Rot rotationOf(const World& world, BodyId body) {
    return readOf(world, world.bodies.pose, body).rotation;
}
[[nodiscard]] inline Vec2 velocityOf(const World& world, BodyId body) {
    return readOf(world, world.bodies.motion, body).velocity;
}
[[nodiscard]] inline float angularVelocityOf(const World& world, BodyId body) {
    return readOf(world, world.bodies.motion, body).angularVelocity;
}
/// Returns the velocity (m/s) of the point of the body that is currently at this position (m).
[[nodiscard]] inline Vec2 velocityAt(const World& world, BodyId body, WorldPosition point) {
    const BodyMotion& motion = readOf(world, world.bodies.motion, body);
    return motion.velocity + cross(motion.angularVelocity, point - centreOf(world, body));
}
[[nodiscard]] inline float massOf(const World& world, BodyId body) {
    return readOf(world, world.bodies.mass, body).mass;
}
using MassData = MassProperties;
[[nodiscard]] inline MassData massDataOf(const World& world, BodyId body) {
    const BodyMass& mass = readOf(world, world.bodies.mass, body);
    return {mass.mass, readOf(world, world.bodies.pose, body).localCentre, mass.inertia};
}
[[nodiscard]] inline bool isEnabled(const World& world, BodyId body) {
    return alive(world, body) && (world.bodies.info[body.index].owned & kBodyOff) == 0;
}
[[nodiscard]] inline bool isAwake(const World& world, BodyId body) {
    return readOf(world, world.bodies.info, body).awakeIndex != kNone;
}
[[nodiscard]] inline const BodyDrive& driveOf(const World& world, BodyId body) {
    return world.bodies.drives[readOf(world, world.bodies.info, body).drive];
}
/// Predicts the pose after dt (s, 0 to a million; NaN counts as 0) if only gravity, drag, setAcceleration(),
/// applied forces and applied torques act on the body for all that time.
[[nodiscard]] Frame predictTransform(const World& world, BodyId body, float dt);
/// The motion computed by predictTransform(): displacement of the center of mass (m) and rotation (rad).
struct FreeMotion {
    Vec2 displacement;
    float angle = 0.0f;
};
[[nodiscard]] FreeMotion freeMotionOf(const World& world, std::uint32_t body, float dt);

// Setters. They return an error for values that are not finite or out of range, or when
// called from a callback of StepOptions::hooks, and then change nothing. A setter that
// moves or accelerates a body wakes it. Setters without a result do nothing in these cases.

/// Makes a body static, kinematic or dynamic. Discards a mass that was set. In the next step its contacts
/// report Ended, and Began if the shapes still touch.
/// @error one of its joints would have no dynamic body any more
Result<Done> setKind(World& world, BodyId body, BodyKind kind);
/// A disabled body keeps its properties, but steps, contacts, joints and queries ignore it until enabled.
void setEnabled(World& world, BodyId body, bool enabled);

Result<Done> setPosition(World& world, BodyId body, WorldPosition position,
                         float angle);                                       ///< m, rad: teleports the body
Result<Done> setVelocity(World& world, BodyId body, Vec2 velocity);          ///< m/s
Result<Done> setAngularVelocity(World& world, BodyId body, float velocity);  ///< rad/s
Result<Done> setAcceleration(World& world, BodyId body, Vec2 acceleration);  ///< m/s2, added to gravity
Result<Done> setGravityScale(World& world, BodyId body, float scale);
Result<Done> setDrag(World& world, BodyId body, float linear, float angular);  ///< 1/s, at least 0
/// Sets the mass (kg) and scales the inertia. 0 restores the values computed from the shapes.
Result<Done> setMass(World& world, BodyId body, float mass);
/// Replaces the computed mass properties, also after shapes are added. Mass 0 restores the computed ones.
Result<Done> setMassData(World& world, BodyId body, const MassData& data);
Result<Done> setQuality(World& world, BodyId body, Quality quality);
/// Forces and torques act in the next step only: at `point` (m, in the world), else at the centre of mass.
Result<Done> applyForce(World& world, BodyId body, Vec2 force);  ///< N
Result<Done> applyForceAt(World& world, BodyId body, Vec2 force, WorldPosition point);
Result<Done> applyTorque(World& world, BodyId body, float torque);   ///< N m
Result<Done> applyImpulse(World& world, BodyId body, Vec2 impulse);  ///< N s
Result<Done> applyImpulseAt(World& world, BodyId body, Vec2 impulse, WorldPosition point);
Result<Done> applyAngularImpulse(World& world, BodyId body, float impulse);  ///< N m s
void clearForces(World& world, BodyId body);  ///< removes applied forces and torques
/// Sets the velocity with which a kinematic body reaches the target in a step of dt (s), limited to
/// Settings::maxSpeed. After that step its velocity is 0.
Result<Done> moveTo(World& world, BodyId body, WorldPosition position, float angle, float dt);
/// Wakes the body's island or puts it to sleep, unless an edit since the last step may have ended a contact.
void setAwake(World& world, BodyId body, bool awake);
void setFixedRotation(World& world, BodyId body, bool fixed);
void setBullet(World& world, BodyId body, bool bullet);
Result<Done> setSleepSpeed(World& world, BodyId body, float speed);  ///< m/s
inline void setUser(World& world, BodyId body, std::uint64_t user) {
    if (!world.work.isInCallback && alive(world, body)) world.bodies.info[body.index].user = user;
}
void setCanSleep(World& world, BodyId body, bool canSleep);
void setLocks(World& world, BodyId body, bool lockX, bool lockY);  ///< locked: velocity along the axis is 0
/// While `drops` is true, one-way shapes do not stop the body, including those that it stands on.
void setDropThrough(World& world, BodyId body, bool drops);

}  // namespace plumb::physics
