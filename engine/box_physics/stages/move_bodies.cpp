#include <algorithm>
#include <cmath>

#include "box_physics/narrowphase/collide.hpp"
#include "box_physics/queries/candidates.hpp"
#include "box_physics/stages.hpp"

namespace plumb::box_physics {

namespace {

constexpr int kMostTurns = 4;       // times that one way may be bent by obstacles in one step
constexpr float kFastPart = 0.25f;  // of its size: a body that moves farther is swept

/// After this, work.path is the way that each body will go: its velocity and what contacts add to it.
void planPaths(StepContext& step) {
    const Bodies& b = step.world.bodies;
    Workspace& work = step.world.work;
    const float moving = (step.effects & kMotion) != 0 ? step.dt : 0.0f;
    work.shift.resize(b.size());
    for (const std::uint32_t i : work.movers) {
        if (b.kind[i] != BodyKind::Dynamic) continue;
        work.path[i] = b.velocity[i] * moving;
        if ((work.marks[i] & kInContact) != 0) {
            work.path[i] += work.shift[i];
        } else {
            work.path[i] -= work.pull[i] * (0.5f * moving * step.dt);  // free flight is exact
        }
    }
}

/// Pushes overlaps apart without giving speed, fixed bodies last.
void pushApart(StepContext& step) {
    const Bodies& b = step.world.bodies;
    Workspace& work = step.world.work;
    for (int i = 0; i < step.settings.positionIterations; ++i) {
        for (const std::uint32_t at : work.order) {
            const Contact& c = work.contacts[at];
            const float gap = c.separation + dot(c.normal, work.path[c.a] - work.path[c.b]);
            if (gap >= -step.settings.slop) continue;
            const float push = std::min(-gap - 0.5f * step.settings.slop, step.settings.maxPush);
            work.path[c.a] += c.normal * (push * c.mass * b.inverseMass[c.a]);
            work.path[c.b] -= c.normal * (push * c.mass * b.inverseMass[c.b]);
        }
    }
}

/// The first fixed thing in the way of a fast body.
Touch firstInTheWay(StepContext& step, const Mover& mover, std::uint32_t body) {
    World& world = step.world;
    Touch best;
    const Vec2 end = mover.centre + mover.path;
    const AABB bounds{min(mover.centre, end) - mover.half, max(mover.centre, end) + mover.half};
    forEachFixed(world, bounds, [&](std::uint32_t other) {
        const bool meets = (world.bodies.layers[body] & world.bodies.mask[other]) != 0 &&
                           (world.bodies.layers[other] & world.bodies.mask[body]) != 0;
        if (!meets || (world.bodies.flags[other] & kTrigger) != 0) return;
        TouchList touches;
        collide(world, mover, other, step.settings, step.up, touches);
        for (int i = 0; i < touches.count; ++i) {
            const Touch& touch = touches.items[i];
            if (dot(touch.normal, mover.path) >= -1e-7f) continue;
            if (!best.hit || touch.time < best.time) best = touch;
        }
    });
    return best;
}

/// Walks a fast body along its way and bends it at whatever the solver had not foreseen.
void sweepBody(StepContext& step, std::uint32_t body) {
    Bodies& b = step.world.bodies;
    Vec2 rest = step.world.work.path[body];
    Vec2 walked;
    for (int turn = 0; turn < kMostTurns && rest != Vec2{}; ++turn) {
        Mover mover = moverOf(step.world, body, rest);
        mover.centre += walked;
        const Touch touch = firstInTheWay(step, mover, body);
        if (!touch.hit) {
            walked += rest;
            break;
        }
        walked += rest * touch.time;
        rest *= 1.0f - touch.time;
        rest -= touch.normal * std::min(dot(rest, touch.normal), 0.0f);
        const float speed = dot(b.velocity[body], touch.normal);
        if (speed < 0.0f) b.velocity[body] -= touch.normal * speed;
    }
    step.world.work.path[body] = walked;
}

bool isFast(const World& world, std::uint32_t body) {
    const Vec2 path = world.work.path[body];
    const Vec2 half = world.bodies.shape[body].half;
    const float size = std::min(half.x, half.y) * 2.0f * kFastPart;
    return (world.work.marks[body] & kNeedsSweep) != 0 || lengthSquared(path) > size * size;
}

/// A number that got lost stops its body where it was, instead of spreading to all it touches.
void moveBody(World& world, std::uint32_t body) {
    Bodies& b = world.bodies;
    if (b.kind[body] == BodyKind::Kinematic && (b.flags[body] & kHasTarget) != 0) {
        if (b.position[body] != b.target[body]) b.flags[body] |= kMoved;
        b.position[body] = b.target[body];
        b.flags[body] = static_cast<std::uint8_t>(b.flags[body] & ~kHasTarget);
        return;
    }
    const Vec2 end = b.position[body] + world.work.path[body];
    if (!isFinite(end) || !isFinite(b.velocity[body])) {
        b.velocity[body] = {};
        return;
    }
    if (end != b.position[body]) b.flags[body] |= kMoved;
    b.position[body] = end;
}

}  // namespace

void moveBodies(StepContext& step) {
    World& world = step.world;
    planPaths(step);
    if ((step.effects & kContacts) != 0) {
        pushApart(step);
        for (const std::uint32_t body : world.work.movers) {
            if (world.bodies.kind[body] != BodyKind::Dynamic || (world.bodies.flags[body] & kTrigger) != 0)
                continue;
            if (isFast(world, body)) sweepBody(step, body);
        }
    }
    for (const std::uint32_t body : world.work.movers) moveBody(world, body);
}

}  // namespace plumb::box_physics
