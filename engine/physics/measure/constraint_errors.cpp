#include "physics/measure/constraint_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/joints/joint_types.hpp"
#include "physics/model/joints.hpp"

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

namespace {

/// A joint with a frequency of its own is a spring, however stiff.
constexpr JointTiming kTiming{1.0f / 60.0f, std::numeric_limits<float>::infinity(), {}};

}  // namespace

float openingOf(const World& world, std::uint32_t index) {
    const Joint& joint = world.joints.hot[index];
    const JointType& type = jointType(joint.kind);
    if (type.constraint != nullptr || joint.kind == JointKind::Mouse) return 0.0f;
    return openingOf(type.parts(viewOf(world, index, kTiming)), type.block(joint.flags));
}

JointReading readingOf(const World& world, JointId id) {
    if (!alive(world, id) || world.joints.hot[id.index].kind == JointKind::Filter) return {};
    const Joint& joint = world.joints.hot[id.index];
    const JointType& type = jointType(joint.kind);
    if (type.constraint != nullptr)
        return {.separation = std::fabs(type.constraint(world, joint, definitionOf(world, id)).error)};
    const JointView view = viewOf(world, id.index, kTiming);
    const JointParts parts = type.parts(view);
    const bool drives = joint.kind == JointKind::Motor && view.definition.motor.on;
    const Vec2 apart = view.between + (parts.armB - parts.armA);
    const BodyMotion& a = world.bodies.motion[joint.bodyA];
    const BodyMotion& b = world.bodies.motion[joint.bodyB];
    const Vec2 speed =
        b.velocity + cross(b.angularVelocity, parts.armB) - a.velocity - cross(a.angularVelocity, parts.armA);
    JointReading reading{.value = angleOf(view),
                         .speed = b.angularVelocity - a.angularVelocity,
                         .motorForce = joint.rows[1],
                         .separation = length(parts.apart)};
    switch (type.block(joint.flags)) {
        case kRodBlocks:
            reading.value = length(apart);
            reading.speed = dot(normalized(apart), speed);
            reading.separation = missOf(parts.value, reading.value);
            break;
        case kSliderBlocks:
            if (joint.kind == JointKind::Wheel) reading.motorForce = joint.rows[5];
            if (parts.holdsAngle) reading.angularSeparation = std::fabs(reading.value);
            reading.value = dot(parts.axis, apart);
            reading.speed = dot(parts.axis, speed) + dot(cross(a.angularVelocity, parts.axis), apart);
            reading.separation =
                std::max(std::fabs(cross(parts.axis, apart)), missOf(parts.value, reading.value));
            break;
        default:
            if (drives) reading.separation = 0.0f;
            reading.angularSeparation = missOf(parts.value, reading.value);
    }
    return reading;
}

}  // namespace plumb::physics
