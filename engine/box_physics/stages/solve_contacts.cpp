#include <algorithm>
#include <cmath>

#include "box_physics/stages.hpp"

namespace plumb::box_physics {

namespace {

void applyImpulse(Bodies& b, const Contact& c, Vec2 impulse) {
    b.velocity[c.a] += impulse * b.inverseMass[c.a];
    b.velocity[c.b] -= impulse * b.inverseMass[c.b];
}

/// Keeps the pair from approaching (or makes it bounce), with an impulse that may push but never pull.
void solveNormal(Bodies& b, Contact& c) {
    const float speed = dot(c.normal, b.velocity[c.a] - b.velocity[c.b]);
    const float before = c.normalImpulse;
    c.normalImpulse = std::max(before - (speed - c.targetSpeed) * c.mass, 0.0f);
    applyImpulse(b, c, c.normal * (c.normalImpulse - before));
}

/// Coulomb friction: at most `friction` times what presses the two together.
void solveFriction(Bodies& b, Contact& c) {
    const Vec2 tangent = perpendicular(c.normal);
    const float speed = dot(tangent, b.velocity[c.a] - b.velocity[c.b]);
    const float most = c.friction * c.normalImpulse;
    const float before = c.tangentImpulse;
    c.tangentImpulse = std::clamp(before - speed * c.mass, -most, most);
    applyImpulse(b, c, tangent * (c.tangentImpulse - before));
}

void markGrounded(const StepContext& step, const Contact& c) {
    Bodies& b = step.world.bodies;
    const float towardsA = dot(c.normal, step.up);
    const float speed = dot(c.normal, b.velocity[c.a] - b.velocity[c.b]);
    if (speed > step.settings.bounceSpeed * 0.1f) return;
    if (towardsA >= step.settings.groundCosine) b.flags[c.a] |= kGrounded;
    if (-towardsA >= step.settings.groundCosine) b.flags[c.b] |= kGrounded;
}

}  // namespace

void solveContacts(StepContext& step) {
    Bodies& b = step.world.bodies;
    Workspace& work = step.world.work;
    for (int i = 0; i < step.settings.velocityIterations; ++i) {
        for (const std::uint32_t at : work.order) {
            Contact& c = work.contacts[at];
            if (c.friction > 0.0f && c.normalImpulse > 0.0f) solveFriction(b, c);
            solveNormal(b, c);
        }
    }
    work.shift.assign(b.size(), Vec2{});
    for (const std::uint32_t at : work.order) {
        const Contact& c = work.contacts[at];
        markGrounded(step, c);
        // The impulse acted when they met, not at the start: until then they moved on as before.
        const Vec2 impulse = c.normal * c.normalImpulse + perpendicular(c.normal) * c.tangentImpulse;
        work.shift[c.a] -= impulse * (b.inverseMass[c.a] * c.time);
        work.shift[c.b] += impulse * (b.inverseMass[c.b] * c.time);
    }
}

}  // namespace plumb::box_physics
