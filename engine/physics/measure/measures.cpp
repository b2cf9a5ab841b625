#include "physics/measure/measures.hpp"

#include <algorithm>
#include <cmath>

#include "physics/contacts/contacts.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/measure/constraint_errors.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/edits.hpp"

namespace plumb::physics {

namespace {

double square(double x, double y) { return x * x + y * y; }

double energyOfMotion(const World& world, std::uint32_t body) {
    const BodyMass& mass = world.bodies.mass[body];
    const BodyMotion& motion = world.bodies.motion[body];
    const auto spin = static_cast<double>(motion.angularVelocity);
    return 0.5 * static_cast<double>(mass.mass) *
               square(static_cast<double>(motion.velocity.x), static_cast<double>(motion.velocity.y)) +
           0.5 * static_cast<double>(mass.inertia) * spin * spin;
}

double energyInGravity(const World& world, std::uint32_t body) {
    const WorldPosition& place = world.bodies.pose[body].centre;
    const BodyDrive& drive = world.bodies.driveOf(body);
    const Vec2 gravity = world.settings.gravity * drive.gravityScale;
    return -static_cast<double>(world.bodies.mass[body].mass) *
           (static_cast<double>(gravity.x) * place.x + static_cast<double>(gravity.y) * place.y);
}

double energyOfSpring(const World& world, const FieldDefinition& spring) {
    const WorldPosition a = worldPoint(world, spring.a, spring.anchorA);
    const WorldPosition b = spring.b ? worldPoint(world, spring.b, spring.anchorB) : spring.place;
    const double stretch = std::sqrt(square(b.x - a.x, b.y - a.y)) - static_cast<double>(spring.length);
    return 0.5 * static_cast<double>(spring.strength) * stretch * stretch;
}

double energyOfAttractor(const World& world, const FieldDefinition& field) {
    const WorldPosition centre = centreOf(world, field);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
        const bool isCentre = field.a && field.a.index == i;
        if (!isDynamic(world, i) || isCentre || !isOnLayers(world, field.layers, i)) continue;
        const WorldPosition& place = world.bodies.pose[i].centre;
        sum += 0.5 * static_cast<double>(world.bodies.mass[i].mass * field.strength) *
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

}  // namespace plumb::physics
