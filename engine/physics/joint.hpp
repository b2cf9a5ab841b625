#pragma once

#include <cstdint>
#include <limits>

#include "math/vec2.hpp"
#include "physics/body.hpp"

namespace plumb::physics {

/// The kinds of joints. Each has one file in joints/ and a row in joints/joint_types.cpp.
enum class JointKind : std::uint8_t {
    Distance,   ///< keeps two points at a length, as a rod, a rope (upper limit alone) or a spring
    Revolute,   ///< a hinge: two points are one; angle with spring, limit and motor
    Prismatic,  ///< a slider: B moves along A's axis and does not turn; spring, limit and motor along it
    Weld,       ///< keeps both as one piece, rigid or springy
    Wheel,      ///< B turns freely and moves along A's axis by a spring; motor turns it
    Mouse,      ///< pulls a point of B to `target` by a spring of limited force
    Motor,      ///< drives B to an offset from A with limited force and torque
    Gear,       ///< ties the turns of B's two joints: angle of jointA + ratio * angle of jointB is constant
    Pulley,     ///< lengthA + ratio * lengthB is constant
    Count
};

struct JointLimit {
    bool on = false;
    float lower = 0.0f;  ///< rad or m
    float upper = 0.0f;
};

struct JointMotor {
    bool on = false;
    float speed = 0.0f;     ///< rad/s or m/s
    float maxForce = 0.0f;  ///< N m or N
};

struct JointSpring {
    bool on = false;
    float hertz = 0.0f;         ///< 1/s; of the spring with what hangs on it
    float dampingRatio = 0.0f;  ///< 1 is critical
    float rest = 0.0f;          ///< rad or m: where it pulls to
};

/// Everything a new joint needs. Unused members of a kind are ignored.
struct JointDefinition {
    JointKind kind = JointKind::Revolute;
    BodyId a;
    BodyId b;
    Vec2 anchorA;                 ///< m, in A's frame
    Vec2 anchorB;                 ///< m, in B's frame
    Vec2 axis{1.0f, 0.0f};        ///< in A's frame: of Prismatic and Wheel
    float referenceAngle = 0.0f;  ///< rad: angle of B minus angle of A that counts as 0
    float length = 1.0f;          ///< m: of Distance; total of Pulley
    float ratio = 1.0f;           ///< of Gear and Pulley
    Vec2 groundA;                 ///< m, world, near the origin of the step: fixed ends of Pulley
    Vec2 groundB;
    Place target;    ///< m: of Mouse
    Vec2 offset;     ///< m, in A's frame: of Motor
    JointId jointA;  ///< of Gear
    JointId jointB;
    JointLimit limit;
    JointMotor motor;
    JointSpring spring;
    float maxForce = std::numeric_limits<float>::infinity();     ///< N: of Mouse and Motor
    float maxTorque = std::numeric_limits<float>::infinity();    ///< N m: of Motor
    float breakForce = std::numeric_limits<float>::infinity();   ///< N: harder pulled, it breaks
    float breakTorque = std::numeric_limits<float>::infinity();  ///< N m
    float hertz = 0.0f;         ///< 1/s: stiffness of the joint itself; 0 as stiff as the substeps allow
    float dampingRatio = 2.0f;  ///< of that
    bool collideConnected = false;
    Quality quality = kQualityOfWorld;
    std::uint64_t user = 0;
};

}  // namespace plumb::physics
