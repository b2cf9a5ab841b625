#include <algorithm>

#include "physics/effects/field_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// One end of a spring, with the inverse mass and inertia of its body.
struct End {
    WorldPosition place;  // m
    Vec2 velocity;
    Vec2 arm;  // m, from the center of mass
    float inverseMass = 0.0f;
    float inverseInertia = 0.0f;
};

End endOf(const World& world, std::uint32_t body, const BodyState& state, Vec2 anchor) {
    const Vec2 arm = rotate(state.rotation, anchor - world.bodies.pose[body].localCentre);
    const BodyMass& mass = world.bodies.mass[body];
    return {state.centre + arm, state.velocity + cross(state.angularVelocity, arm), arm, mass.inverseMass,
            mass.inverseInertia};
}

float easeOf(const End& end, Vec2 along) {
    const float lever = cross(end.arm, along);
    return end.inverseMass + end.inverseInertia * lever * lever;
}

}  // namespace

/// F = strength * (length - rest) + damping * speed. A spring that is too stiff for the step is softened to
/// what the step can follow; otherwise it would gain energy without bound.
Acceleration spring(const FieldView& view, const FieldDefinition& field, std::uint32_t body,
                    const BodyState& state) {
    const bool isA = field.a.index == body;
    const End here = endOf(view.world, body, state, isA ? field.anchorA : field.anchorB);
    End there{field.place, {}, {}, 0.0f, 0.0f};
    if (field.b) {
        const std::uint32_t other = isA ? field.b.index : field.a.index;
        there = endOf(view.world, other, view.stateOf(view, other), isA ? field.anchorB : field.anchorA);
    }
    const Vec2 displacement = there.place - here.place;
    const float size = length(displacement);
    if (size <= 0.0f) return {};
    const Vec2 along = displacement / size;
    const float ease = easeOf(here, along) + easeOf(there, along);
    if (ease <= 0.0f) return {};
    const float damping = std::min(field.damping, 1.0f / (ease * view.h));
    const float stiffest = kStiffest * (4.0f / view.h - 2.0f * damping * ease) / (ease * view.h);
    const float pull = std::min(field.strength, stiffest) * (size - field.length) +
                       damping * dot(along, there.velocity - here.velocity);
    const Vec2 force = pull * along;
    return {here.inverseMass * force, here.inverseInertia * cross(here.arm, force)};
}

}  // namespace plumb::physics
