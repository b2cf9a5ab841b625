#include <cmath>

#include "box_physics/stages.hpp"

namespace plumb::box_physics {

namespace {

/// The way a body would go if nothing were in it. Where acceleration brakes, the exact way is the longer
/// one, where it speeds up, the other: the longer of both is searched, so nothing slips between them.
Vec2 searchedPath(Vec2 velocity, Vec2 pull, float dt) {
    const Vec2 path = velocity * dt;
    return dot(velocity, pull) < 0.0f ? path - pull * (0.5f * dt * dt) : path;
}

Vec2 limited(Vec2 velocity, float most) {
    const float speed = length(velocity);
    return speed > most ? velocity * (most / speed) : velocity;
}

/// Room for what a crowd of this size usually needs, so that a steady scene does not allocate.
void makeRoom(World& world) {
    Workspace& work = world.work;
    const std::size_t usual = work.movers.size() * 4 + 64;
    if (work.contacts.capacity() >= usual) return;
    work.contacts.reserve(usual), work.order.reserve(usual);
    work.pairs.reserve(usual), work.unsortedPairs.reserve(usual);
    work.touching.reserve(usual), world.touching.reserve(usual), world.events.reserve(usual);
}

}  // namespace

void applyForces(StepContext& step) {
    Bodies& b = step.world.bodies;
    Workspace& work = step.world.work;
    const std::size_t count = b.size();
    work.path.resize(count), work.pull.resize(count), work.bounds.resize(count), work.marks.resize(count);
    work.movers.clear();
    const Vec2 gravity = (step.effects & kGravity) != 0 ? step.settings.gravity : Vec2{};
    const float moving = (step.effects & kMotion) != 0 ? 1.0f : 0.0f;
    for (std::uint32_t i = 0; i < count; ++i) {
        work.marks[i] = 0;
        if (b.kind[i] == BodyKind::None || b.kind[i] == BodyKind::Static) {
            work.path[i] = work.pull[i] = {};
            continue;
        }
        work.movers.push_back(i);
        b.flags[i] = static_cast<std::uint8_t>(b.flags[i] & ~(kGrounded | kMoved));
        if (b.kind[i] == BodyKind::Kinematic) {
            if ((b.flags[i] & kHasTarget) != 0)
                b.velocity[i] = (b.target[i] - b.position[i]) * (1.0f / step.dt);
            work.pull[i] = {};
            work.path[i] = b.velocity[i] * (step.dt * moving);
            if ((b.flags[i] & kHasTarget) != 0) work.path[i] = b.target[i] - b.position[i];
        } else {
            work.pull[i] = gravity * b.gravityScale[i] + b.acceleration[i] * moving;
            b.velocity[i] = limited(b.velocity[i] + work.pull[i] * step.dt, step.settings.maxSpeed);
            work.path[i] = searchedPath(b.velocity[i], work.pull[i], step.dt) * moving;
        }
        const AABB start = b.shape[i].boundsAt(b.position[i]);
        const AABB end{start.min + work.path[i], start.max + work.path[i]};
        work.bounds[i] = grown(merged(start, end), step.settings.touchDistance);
    }
    makeRoom(step.world);
}

}  // namespace plumb::box_physics
