#include "physics/measure/constraint_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/joints/joint_types.hpp"

namespace plumb::physics {

namespace {

/// Deviation of a length or an angle from where it is held, or excess over its limits.
float missOf(const ValueParts& parts, float value) {
    float miss = parts.held && !parts.springs ? std::fabs(value - parts.rest) : 0.0f;
    if (parts.limited) miss = std::max({miss, parts.lower - value, value - parts.upper});
    return miss;
}

float longestArm(const JointParts& parts) { return std::max(length(parts.armA), length(parts.armB)); }

float openingOf(const JointParts& parts, JointBlockKind kind) {
    switch (kind) {
        case kPointBlocks: return length(parts.apart);
        case kHingeBlocks: {
            const float turned = missOf(parts.value, parts.angle) * longestArm(parts);
            return std::max(parts.springs ? 0.0f : length(parts.apart), turned);
        }
        case kRodBlocks: return missOf(parts.value, length(parts.apart));
        case kSliderBlocks: {
            const float turned = parts.holdsAngle ? std::fabs(parts.angle) * longestArm(parts) : 0.0f;
            return std::max({std::fabs(cross(parts.axis, parts.apart)), turned,
                             missOf(parts.value, dot(parts.axis, parts.apart))});
        }
        default: return 0.0f;
    }
}

}  // namespace

float overlapOf(const Contact& contact) {
    if ((contact.flags & (kTouching | kTriggered | kDisabled)) != kTouching) return 0.0f;
    return std::max(0.0f, -std::min(contact.separation0, contact.separation1));
}

float openingOf(const World& world, std::uint32_t index) {
    // A joint with a frequency of its own is a spring, however stiff.
    constexpr JointTiming kTiming{1.0f / 60.0f, std::numeric_limits<float>::infinity(), {}};
    const Joint& joint = world.joints.hot[index];
    const JointType& type = jointType(joint.kind);
    if (type.constraint != nullptr || joint.kind == JointKind::Mouse) return 0.0f;
    const BodyPose& a = world.bodies.pose[joint.bodyA];
    const BodyPose& b = world.bodies.pose[joint.bodyB];
    const JointView view{
        joint, world.joints.definition[index], kTiming, a.rotation, b.rotation, b.centre - a.centre, {}};
    return openingOf(type.parts(view), type.block(joint.flags));
}

}  // namespace plumb::physics
