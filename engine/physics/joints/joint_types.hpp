#pragma once

#include <string_view>

#include "physics/solver/tie.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// What a substep is to joints.
struct JointTiming {
    float h = 0.0f;         ///< s
    float stiffest = 0.0f;  ///< 1/s: a spring of this rate is as good as rigid
    Grip rigid;             ///< of what is as stiff as the substeps allow
};

/// A joint and how its bodies are at the start of the step.
struct JointView {
    const Joint& joint;
    const JointDefinition& definition;
    const JointTiming& timing;
    Rot turnA;
    Rot turnB;
    Vec2 between;   ///< m: from A's centre of mass to B's
    Vec2 toTarget;  ///< m: from JointDefinition::target to B's centre of mass
};

/// More than any impulse: of what is not limited.
inline constexpr float kNoLimit = 1.0e18f;

/// What is done to a length or an angle.
struct ValueParts {
    bool held = false;
    bool springs = false;   ///< it is held by a spring
    Grip grip;              ///< of what holds it
    float rest = 0.0f;      ///< m or rad: where
    float most = kNoLimit;  ///< N s or N m s
    bool driven = false;
    float speed = 0.0f;      ///< m/s or rad/s
    float mostMotor = 0.0f;  ///< N s or N m s
    bool limited = false;
    float lower = -kNoLimit;  ///< m or rad
    float upper = kNoLimit;
};

/// A joint, as the parts that the solver knows. Which of them count, its block kind says.
struct JointParts {
    Vec2 armA;  ///< m, world, from the centre of mass
    Vec2 armB;
    Vec2 apart;  ///< m: from A's anchor to B's
    Grip grip;   ///< of the point
    bool springs = false;
    float most = kNoLimit;  ///< N s
    bool isDirect = false;  ///< the point is held in a tree: solve_trees.hpp
    float angle = 0.0f;     ///< rad: of B seen from A, less the reference angle
    ValueParts value;       ///< of the angle (hinges) or the length (rods, sliders)
    Vec2 axis;              ///< world: of sliders
    bool holdsAngle = false;
    float spin = 0.0f;      ///< rad/s: of a slider's motor that turns
    float mostSpin = 0.0f;  ///< N m s
};

/// One kind of joint. A new one is a file in joints/, a row in the table, and a test.
struct JointType {
    std::string_view name;
    JointBlockKind (*block)(std::uint8_t flags);  ///< by bits of JointFlag
    JointParts (*parts)(const JointView& view);
    /// Instead of both: of a joint that is no matter of two bodies and their anchors.
    Tie (*tie)(const World& world, const Joint& joint, const JointDefinition& definition) = nullptr;
};

const JointType& jointType(JointKind kind);

// What the files of joints share.

/// Both anchors, as they are in the world.
JointParts anchorsOf(const JointView& view);
/// rad, -pi..pi: of B seen from A, less the reference angle.
float angleOf(const JointView& view);
/// The spring that JointDefinition asks for, with what its mass is: exact in frequency, damping and sag as
/// long as it is much slower than the substeps.
Grip springGrip(float hertz, float dampingRatio, float h);
/// How stiff the joint itself is: rigid, or a spring with JointDefinition::hertz.
/// @return true for a spring
bool ownGrip(const JointView& view, Grip& grip);
/// Limits and motor, and the spring as what holds it.
ValueParts valueParts(const JointView& view);

}  // namespace plumb::physics
