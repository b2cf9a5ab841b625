#include <algorithm>
#include <cmath>

#include "physics/effects/field_types.hpp"
#include "physics/effects/submerged.hpp"

namespace plumb::physics {

namespace {

/// m: half width and depth that stand for an unbounded fluid.
constexpr float kEndless = 1.0e7f;

/// A fluid in a frame whose y axis points along gravity.
struct Fluid {
    WorldPosition surface;  // m: middle of the surface
    Rot turn;               // from the frame of FluidBox to the world: x along the surface, y down
    FluidBox box;
};

Fluid fluidOf(const World& world, const FieldDefinition& field) {
    const Vec2 gravity = world.settings.gravity;
    const Vec2 down = lengthSquared(gravity) > 0.0f ? normalized(gravity) : Vec2{0.0f, 1.0f};
    const Rot turn{down.y, -down.x};  // rotates (0, 1) to `down`
    if (field.region == RegionKind::Everywhere) return {field.place, turn, {kEndless, kEndless}};
    const Vec2 half = field.region == RegionKind::Circle ? Vec2{field.radius, field.radius} : field.half;
    const float along = std::fabs(turn.cos) * half.x + std::fabs(turn.sin) * half.y;
    const float deep = std::fabs(turn.sin) * half.x + std::fabs(turn.cos) * half.y;
    return {field.place + -deep * down, turn, {along, 2.0f * deep}};
}

}  // namespace

/// Archimedes' principle: each shape is lifted by the weight of the fluid that it displaces, at the centroid
/// of its submerged part. Drag is proportional to the displaced mass.
Acceleration buoyancy(const FieldView& view, const FieldDefinition& field, std::uint32_t body,
                      const BodyState& state) {
    const World& world = view.world;
    const Fluid fluid = fluidOf(world, field);
    const BodyMass& mass = world.bodies.mass[body];
    const Vec2 origin =
        state.centre - fluid.surface - rotate(state.rotation, world.bodies.pose[body].localCentre);
    const Frame toFluid{unrotate(fluid.turn, origin), between(fluid.turn, state.rotation)};
    Acceleration sum;
    float displaced = 0.0f;  // kg
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next) {
        const Submerged part =
            submergedPart(world.shapes.geometry[s], world.shapes.corners, toFluid, fluid.box);
        if (part.area == 0.0f || (world.shapes.info[s].flags & kTrigger) != 0) continue;
        const float weight = field.density * part.area;
        const Vec2 arm = rotate(fluid.turn, part.centre) - (state.centre - fluid.surface);
        const Vec2 felt = field.velocity - (state.velocity + cross(state.angularVelocity, arm));
        const float rate = std::min(field.linearDrag * weight, 1.0f / (view.h * mass.inverseMass));
        const Vec2 force = -weight * world.settings.gravity + rate * felt;
        sum += {mass.inverseMass * force, mass.inverseInertia * cross(arm, force)};
        displaced += weight;
    }
    const float rate = field.angularDrag * displaced * mass.inverseMass;
    if (mass.inverseInertia > 0.0f) sum.angular -= std::min(rate, 1.0f / view.h) * state.angularVelocity;
    return sum;
}

}  // namespace plumb::physics
