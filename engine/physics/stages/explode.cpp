#include <algorithm>

#include "physics/model/fields.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Impulse J = strength * width * (1 - distance / radius): width of the shape as seen from the explosion,
/// distance of its closest point. It acts at the center of the shape, away from the explosion.
void pushAway(World& world, const FieldDefinition& explosion, std::uint32_t body) {
    const BodyPose& pose = world.bodies.pose[body];
    const BodyMass& mass = world.bodies.mass[body];
    BodyMotion& motion = world.bodies.motion[body];
    const Vec2 centre = pose.localCentre + unrotate(pose.rotation, explosion.place - pose.centre);
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next) {
        if ((world.shapes.info[s].flags & kTrigger) != 0) continue;
        const Geometry& geometry = world.shapes.geometry[s];
        const ClosestPoint nearest = closestPoint(geometry, world.shapes.corners, centre);
        const float distance = std::max(nearest.distance, 0.0f);
        if (distance >= explosion.radius) continue;
        const Vec2 middle = convexOf(geometry, world.shapes.corners).centre;
        Vec2 away = normalized(middle - centre);
        if (away == Vec2{}) away = kAnyNormal;
        const float size = explosion.strength * widthAcross(geometry, world.shapes.corners, away) *
                           (1.0f - distance / explosion.radius);
        const Vec2 impulse = rotate(pose.rotation, size * away);
        motion.velocity += mass.inverseMass * impulse;
        motion.angularVelocity +=
            mass.inverseInertia * cross(rotate(pose.rotation, middle - pose.localCentre), impulse);
    }
}

}  // namespace

void explode(StepContext& step) {
    World& world = step.world;
    const auto explodes = [&](std::uint32_t f) {
        return world.fields.all[f].isAlive && world.fields.all[f].definition.kind == FieldKind::Explosion;
    };
    constexpr std::uint32_t kKinds = 1u << static_cast<unsigned>(FieldKind::Explosion);
    forFieldsOnBodies(world, step.work, kKinds, [&](std::uint32_t body, std::uint32_t f) {
        if (explodes(f)) pushAway(world, world.fields.all[f].definition, body);
    });
    for (std::uint32_t f = 0; f < world.fields.all.size(); ++f) {
        if (explodes(f)) destroyField(world, {f, world.fields.all[f].generation});
    }
}

}  // namespace plumb::physics
