#pragma once

#include <cstdint>
#include <limits>

#include "physics/model/body.hpp"

namespace plumb::physics {

/// The kinds of joints. Each has a row in joints/joint_types.cpp.
enum class JointKind : std::uint8_t {
    Distance,   ///< keeps two points at a distance: a rod, a rope (only an upper limit) or a spring
    Revolute,   ///< a hinge: two points coincide; spring, limit and motor act on the angle
    Prismatic,  ///< a slider: B moves along A's axis without rotating; spring, limit and motor
    Weld,       ///< keeps the relative pose of both bodies, rigid or springy
    Wheel,      ///< B rotates freely and moves along A's axis on a spring; a motor rotates it
    Mouse,      ///< pulls a point of B to `target` by a spring of limited force
    Motor,      ///< moves B to an offset from A, or at a velocity, with limited force and torque
    Gear,       ///< keeps a + ratio * b constant; a, b: angle (rad) or translation (m) of jointA, jointB
    Pulley,     ///< keeps lengthA + ratio * lengthB constant
    Filter,     ///< disables collisions between the two bodies
    Count
};

struct JointLimit {
    bool on = false;
    float lower = 0.0f;  ///< m or rad; angles from -pi to pi, and at least 0.1 rad are left out in all
    float upper = 0.0f;
};

struct JointMotor {
    bool on = false;
    float speed = 0.0f;     ///< rad/s or m/s
    float maxForce = 0.0f;  ///< N m or N
};

struct JointSpring {
    bool on = false;
    float hertz = 0.0f;         ///< Hz: frequency of the spring with the effective mass of the two bodies
    float dampingRatio = 0.0f;  ///< 1: critically damped
    float rest = 0.0f;          ///< rad or m: rest position; Distance uses `length` instead
};

/// Properties of a new joint. Members that a kind does not use are ignored.
struct JointDefinition {
    JointKind kind = JointKind::Revolute;
    BodyId a{};
    BodyId b{};
    Vec2 anchorA{};               ///< m, in A's frame
    Vec2 anchorB{};               ///< m, in B's frame
    Vec2 axis{1.0f, 0.0f};        ///< sliding axis of Prismatic and Wheel, in A's frame
    float referenceAngle = 0.0f;  ///< rad: difference of angles (B minus A) that counts as 0
    float length = 1.0f;          ///< m: length of Distance; total length of Pulley
    float ratio = 1.0f;           ///< ratio of Gear and Pulley, see JointKind
    Vec2 groundA{};               ///< m, in the world: fixed ends of Pulley; must be near the origin (float)
    Vec2 groundB{};
    WorldPosition target{};  ///< m: target of Mouse
    Vec2 offset{};           ///< m, in A's frame: offset of Motor
    /// m/s, in A's frame: velocity of Motor with motor.on. It then moves B's anchor relative to A at this
    /// velocity and motor.speed, instead of to the offset.
    Vec2 velocity{};
    JointId jointA{};  ///< first joint of Gear
    JointId jointB{};  ///< second joint of Gear
    JointLimit limit{};
    JointMotor motor{};
    JointSpring spring{};  ///< Weld: spring of its angle
    /// N: force limit of Mouse and Motor. Mouse accelerates B by at most 1000 m/s2, so that contacts hold.
    float maxForce = std::numeric_limits<float>::infinity();
    float maxTorque = std::numeric_limits<float>::infinity();     ///< N m: limit of Motor
    float breakForce = std::numeric_limits<float>::infinity();    ///< N: a larger force breaks the joint
    float breakTorque = std::numeric_limits<float>::infinity();   ///< N m: a larger torque breaks the joint
    float reportForce = std::numeric_limits<float>::infinity();   ///< N: see World::strainedJoints
    float reportTorque = std::numeric_limits<float>::infinity();  ///< N m
    float hertz = 0.0f;         ///< Hz: stiffness of the constraint itself; 0: the maximum for the substeps
    float dampingRatio = 2.0f;  ///< used with `hertz`
    bool collideConnected = false;
    Quality quality = kQualityOfWorld;
    std::uint64_t user = 0;
};

}  // namespace plumb::physics
