#include "physics/measure/measures.hpp"

#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/joints/joint_types.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/joints.hpp"

namespace plumb::physics {

namespace {

double square(double x, double y) { return x * x + y * y; }

double energyOfMotion(const World& world, std::uint32_t body) {
    const BodyMass& mass = world.bodies.mass[body];
    const BodyMotion& motion = world.bodies.motion[body];
    const Double2 velocity = wide(motion.velocity);
    const double spin{motion.angularVelocity};
    return 0.5 * double{mass.mass} * dot(velocity, velocity) + 0.5 * double{mass.inertia} * spin * spin;
}

double energyInGravity(const World& world, std::uint32_t body) {
    const WorldPosition& at = world.bodies.pose[body].centre;
    const Vec2 gravity = world.settings.gravity * world.bodies.driveOf(body).gravityScale;
    return -double{world.bodies.mass[body].mass} * (double{gravity.x} * at.x + double{gravity.y} * at.y);
}

double energyOfSpring(const World& world, const FieldDefinition& spring) {
    const WorldPosition a = worldPoint(world, spring.a, spring.anchorA);
    const WorldPosition b = spring.b ? worldPoint(world, spring.b, spring.anchorB) : spring.place;
    const double stretch = std::sqrt(square(b.x - a.x, b.y - a.y)) - double{spring.length};
    return 0.5 * double{spring.strength} * stretch * stretch;
}

double energyOfAttractor(const World& world, const FieldDefinition& field) {
    const WorldPosition centre = centreOf(world, field);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
        const bool isCentre = field.a && field.a.index == i;
        if (!isDynamic(world, i) || isCentre || !isOnLayers(world, field.layers, i)) continue;
        const WorldPosition& place = world.bodies.pose[i].centre;
        sum += 0.5 * double{world.bodies.mass[i].mass * field.strength} *
               square(place.x - centre.x, place.y - centre.y);
    }
    return sum;
}

double energyOfField(const World& world, const Field& field) {
    if (!field.isAlive) return 0.0;
    const FieldDefinition& definition = field.definition;
    if (definition.kind == FieldKind::Spring) return energyOfSpring(world, definition);
    const bool spreads = definition.kind == FieldKind::Attractor && definition.linear;
    return spreads ? energyOfAttractor(world, definition) : 0.0;
}

/// Returns the deviation of a length or an angle from its fixed value, or the excess over its limits.
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

/// Timing with which a joint with JointDefinition::hertz counts as a spring at any stiffness.
constexpr JointTiming kTiming{1.0f / 60.0f, std::numeric_limits<float>::infinity(), {}};

}  // namespace

double energyOf(const World& world) {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
        if (isDynamic(world, i)) sum += energyOfMotion(world, i) + energyInGravity(world, i);
    }
    for (const Field& field : world.fields.all) sum += energyOfField(world, field);
    return sum;
}

float deepestOverlapOf(const World& world) {
    float deepest = 0.0f;
    forContacts(world, [&](const Contact& contact) { deepest = std::max(deepest, overlapOf(contact)); });
    return deepest;
}

double largestDistanceOf(const World& world, const World& other) {
    double largest = 0.0;
    const auto count = std::min(world.bodies.size(), other.bodies.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool same = world.bodies.info[i].generation == other.bodies.info[i].generation;
        if (!same || !isDynamic(world, i) || !isDynamic(other, i)) continue;
        const WorldPosition& here = world.bodies.pose[i].centre;
        const WorldPosition& there = other.bodies.pose[i].centre;
        largest = std::max(largest, square(here.x - there.x, here.y - there.y));
    }
    return std::sqrt(largest);
}

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
            if (joint.kind == JointKind::Motor) reading.separation = drives ? 0.0f : length(apart);
            reading.angularSeparation = missOf(parts.value, reading.value);
    }
    return reading;
}

}  // namespace plumb::physics
