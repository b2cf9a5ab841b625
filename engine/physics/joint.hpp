#pragma once

#include <cstdint>
#include <limits>

#include "math/vec2.hpp"
#include "physics/body.hpp"

namespace plumb::physics {

// clang-format off
/// The table of joints. Each is a file joints/<name>_joint.cpp with a JointType named k<Name>Joint.
#define PLUMB_JOINTS(JOINT)                                                                                \
    JOINT(Distance)  /* keeps two points at a length, as a rod, a rope (upper limit alone) or a spring */ \
    JOINT(Revolute)  /* a hinge: two points are one; angle with spring, limit and motor */                \
    JOINT(Prismatic) /* a slider: B moves along A's axis and does not turn; spring, limit and motor */    \
    JOINT(Weld)      /* keeps both as one piece, rigid or springy */                                      \
    JOINT(Wheel)     /* B turns freely and moves along A's axis by a spring; motor turns it */            \
    JOINT(Mouse)     /* pulls a point of B to `target` by a spring of limited force */                    \
    JOINT(Motor)     /* drives B to an offset from A with limited force and torque */                     \
    JOINT(Gear)      /* angle of jointA + ratio * angle of jointB stays as it is */                       \
    JOINT(Pulley)    /* lengthA + ratio * lengthB stays as it is */
// clang-format on

enum class JointKind : std::uint8_t {
#define PLUMB_NAME(name) name,
    PLUMB_JOINTS(PLUMB_NAME)
#undef PLUMB_NAME
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
    BodyId a{};
    BodyId b{};
    Vec2 anchorA{};               ///< m, in A's frame
    Vec2 anchorB{};               ///< m, in B's frame
    Vec2 axis{1.0f, 0.0f};        ///< in A's frame: of Prismatic and Wheel
    float referenceAngle = 0.0f;  ///< rad: angle of B minus angle of A that counts as 0
    float length = 1.0f;          ///< m: of Distance; total of Pulley
    float ratio = 1.0f;           ///< of Gear and Pulley
    Vec2 groundA{};               ///< m, world, near enough to the origin to be float: fixed ends of Pulley
    Vec2 groundB{};
    Place target{};    ///< m: of Mouse
    Vec2 offset{};     ///< m, in A's frame: of Motor
    JointId jointA{};  ///< of Gear
    JointId jointB{};
    JointLimit limit{};
    JointMotor motor{};
    JointSpring spring{};
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
