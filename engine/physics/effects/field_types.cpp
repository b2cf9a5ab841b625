#include "physics/effects/field_types.hpp"

#include <cmath>

#include "physics/model/edits.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

namespace {

bool isInRegion(const FieldDefinition& field, Vec2 displacement, float reach) {
    const RegionKind region = regionOf(field);
    if (region == RegionKind::Circle) return length(displacement) <= field.radius + reach;
    return region != RegionKind::Box || (std::fabs(displacement.x) <= field.half.x + reach &&
                                         std::fabs(displacement.y) <= field.half.y + reach);
}

}  // namespace

bool isOnLayers(const World& world, std::uint32_t layers, std::uint32_t body) {
    if (layers == 0xffffffffu) return true;
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next) {
        if ((world.shapes.filter[s].layers & layers) != 0) return true;
    }
    return false;
}

WorldPosition centreOf(const World& world, const FieldDefinition& field) {
    const bool follows = field.kind == FieldKind::Attractor && field.a;
    return follows ? world.bodies.pose[field.a.index].centre : field.place;
}

bool actsOn(const World& world, const FieldDefinition& field, std::uint32_t body) {
    if (field.kind == FieldKind::Spring) return field.a.index == body || (field.b && field.b.index == body);
    if (field.kind == FieldKind::Attractor && field.a && field.a.index == body) return false;
    if (!isOnLayers(world, field.layers, body)) return false;
    const Vec2 displacement = world.bodies.pose[body].centre - centreOf(world, field);
    // Fluids and explosions act on outlines, all other fields on centers of mass.
    const bool byOutline = field.kind == FieldKind::Buoyancy || field.kind == FieldKind::Explosion;
    const float reach = byOutline ? world.bodies.info[body].reach : 0.0f;
    return isInRegion(field, displacement, reach);
}

bool isInRegion(const FieldDefinition& field, WorldPosition place) {
    return isInRegion(field, place - field.place, 0.0f);
}

bool isConstant(const FieldDefinition& field) {
    return field.kind == FieldKind::AreaGravity && field.strength == 0.0f;
}

Acceleration accelerationAt(const FieldView& view, std::span<const std::uint32_t> fields, std::uint32_t body,
                            const BodyState& state) {
    Acceleration sum;
    for (const std::uint32_t f : fields) {
        const FieldDefinition& field = view.world.fields.all[f].definition;
        if (!view.withSteady && isConstant(field)) continue;
        if (const auto acceleration = fieldTypeOf(field.kind).acceleration; acceleration != nullptr) {
            sum += acceleration(view, field, body, state);
        }
    }
    const std::uint8_t flags = view.world.bodies.info[body].flags;
    if ((flags & kLockX) != 0) sum.linear.x = 0.0f;
    if ((flags & kLockY) != 0) sum.linear.y = 0.0f;
    return sum;
}

BodyState stateAtStart(const World& world, std::uint32_t body) {
    const BodyPose& pose = world.bodies.pose[body];
    const BodyMotion& motion = world.bodies.motion[body];
    return {pose.centre, pose.rotation, motion.velocity, motion.angularVelocity};
}

float widthAcross(const Geometry& geometry, std::span<const Corner> corners, Vec2 direction) {
    const Convex convex = convexOf(geometry, corners);
    const Vec2 across = perpendicular(direction);
    const auto reach = [&](Vec2 side) {
        return dot(side, convex.corners()[static_cast<std::size_t>(farthest(convex.corners(), side))].point);
    };
    return reach(across) + reach(-across) + 2.0f * convex.radius;
}

float widthAcross(const World& world, std::uint32_t body, Rot rotation, Vec2 direction) {
    const Vec2 local = unrotate(rotation, direction);
    float width = 0.0f;
    forShapesOf(world, body, [&](std::uint32_t s) {
        if ((world.shapes.info[s].flags & kTrigger) == 0)
            width += widthAcross(world.shapes.geometry[s], world.shapes.corners, local);
    });
    return width;
}

}  // namespace plumb::physics
