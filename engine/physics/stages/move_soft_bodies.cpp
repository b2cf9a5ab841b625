#include <algorithm>
#include <cmath>
#include <span>

#include "math/portable.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// m/s: a particle this fast wakes what it hits.
constexpr float kRousing = 0.5f;

/// One soft body in one substep.
struct SoftStep {
    StepContext& step;
    SoftBody& body;
    std::span<const std::uint32_t> shapes;  // near it
    float h;                                // s
    float left;                             // ratio of the step, from the middle of this substep on
};

/// Each particle is as wide in the wind as the way to its neighbour.
void blowOn(const SoftStep& soft, const FieldDefinition& wind) {
    if ((wind.layers & soft.body.layers) == 0) return;
    const Vec2 air = airOf(wind, soft.step.world.steps);
    const float width = soft.body.links.empty() ? 2.0f * soft.body.radius : soft.body.links.front().length;
    for (SoftParticle& p : soft.body.particles) {
        if (p.inverseMass == 0.0f || !isInRegion(wind, p.place)) continue;
        const Vec2 felt = air - p.velocity;
        const float rate = wind.density * width * length(felt) * p.inverseMass;  // 1/s
        p.velocity += std::min(rate * soft.h, 1.0f) * felt;
    }
}

void blow(const SoftStep& soft) {
    if (!soft.step.world.manifest.runs(Effect::Wind)) return;
    for (const Field& field : soft.step.world.fields.all) {
        if (field.isAlive && field.definition.kind == FieldKind::Wind) blowOn(soft, field.definition);
    }
}

void moveFreely(const SoftStep& soft) {
    const bool pulled = (soft.step.world.manifest.pinnedOff & Manifest::bit(Effect::Gravity)) == 0;
    const Vec2 pull = pulled ? soft.step.world.settings.gravity : Vec2{};
    const float kept = exponential(-soft.body.damping * soft.h);
    const float maximum = soft.step.world.settings.maxSpeed;
    for (SoftParticle& p : soft.body.particles) {
        p.before = p.place;
        if (p.inverseMass == 0.0f) continue;
        p.velocity = kept * (p.velocity + soft.h * pull);
        const float speed = length(p.velocity);
        if (!(speed <= maximum)) p.velocity = std::isfinite(speed) ? (maximum / speed) * p.velocity : Vec2{};
        p.place = p.place + soft.h * p.velocity;
    }
}

/// C = |b - a| - length. One iteration a substep, so the multiplier starts at 0 (XPBD, Eq. 18).
void keepLengths(const SoftStep& soft) {
    const float perStep = 1.0f / (soft.h * soft.h);
    for (const SoftLink& link : soft.body.links) {
        SoftParticle& a = soft.body.particles[link.a];
        SoftParticle& b = soft.body.particles[link.b];
        const Vec2 displacement = b.place - a.place;
        const float size = length(displacement), weight = a.inverseMass + b.inverseMass;
        if (size <= 0.0f || weight <= 0.0f) continue;
        const Vec2 push =
            (-(size - link.length) / (weight + link.compliance * perStep) / size) * displacement;
        a.place = a.place + -a.inverseMass * push;
        b.place = b.place + b.inverseMass * push;
    }
}

/// C = area - area at rest, whose gradient at a particle is half of its neighbours' way, turned.
void keepArea(const SoftStep& soft) {
    const std::vector<std::uint32_t>& ring = soft.body.ring;
    if (ring.empty()) return;
    std::vector<SoftParticle>& particles = soft.body.particles;
    const std::size_t count = ring.size();
    const WorldPosition origin = particles[ring[0]].place;
    const auto at = [&](std::size_t i) { return particles[ring[i % count]].place - origin; };
    const auto gradient = [&](std::size_t i) { return -0.5f * perpendicular(at(i + 1) - at(i + count - 1)); };
    float area = 0.0f, weight = soft.body.areaCompliance / (soft.h * soft.h);
    for (std::size_t i = 0; i < count; ++i) {
        area += 0.5f * cross(at(i), at(i + 1));
        weight += particles[ring[i]].inverseMass * lengthSquared(gradient(i));
    }
    if (!(weight > 0.0f)) return;
    const float push = -(area - soft.body.area) / weight;
    // All gradients are of one moment: each needs its neighbours as they were.
    const Vec2 first = at(0);
    Vec2 last = at(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 here = at(i), next = i + 1 < count ? at(i + 1) : first;
        SoftParticle& p = particles[ring[i]];
        // `origin` is a copy, so that particle 0 may move.
        p.place = p.place + (push * p.inverseMass) * (-0.5f * perpendicular(next - last));
        last = here;
    }
}

/// m: how much of an overlap that was there before is taken away in a substep.
float easedOf(const SoftStep& soft, float overlap) {
    const Settings& settings = soft.step.world.settings;
    return std::min(overlap, (settings.pushSpeed + settings.deepPushRate * overlap) * soft.h);
}

/// Stops what comes nearer than the radius. Of an overlap, what came in this substep is an impulse on both;
/// the rest is put right and gives no speed, or it would feed them.
void keepOut(const SoftStep& soft, SoftParticle& p, std::uint32_t shape, SoftObstacle& obstacle) {
    const World& world = soft.step.world;
    const Vec2 arm = p.place - obstacle.centre;
    const ClosestPoint nearest = closestPoint(world.shapes.geometry[shape], world.shapes.corners,
                                              obstacle.localCentre + unrotate(obstacle.rotation, arm));
    const float depth = soft.body.radius - nearest.distance;
    if (!(depth > 0.0f)) return;
    if (obstacle.rests && length(p.velocity) > kRousing) rouse(soft.step, obstacle);
    const Vec2 normal = rotate(obstacle.rotation, nearest.normal), along = perpendicular(normal);
    const Vec2 displacement = (p.place - p.before) - obstacle.displacement(arm);
    const float came = std::clamp(-dot(displacement, normal), 0.0f, depth);
    const float push = came / (p.inverseMass + obstacle.weight(arm, normal));
    const float hold = dot(displacement, along) / (p.inverseMass + obstacle.weight(arm, along));
    const float rub = std::clamp(hold, -soft.body.friction * push, soft.body.friction * push);
    const Vec2 impulse = push * normal - rub * along;
    const Vec2 eased = easedOf(soft, depth - came) * normal;
    p.place = p.place + (p.inverseMass * impulse + eased);
    p.before = p.before + eased;
    pushObstacle(obstacle, arm, -impulse, soft.h, soft.left);
}

void keepOutOfAll(const SoftStep& soft) {
    SoftSurroundings& around = soft.step.work.softSurroundings;
    for (const std::uint32_t shape : soft.shapes) {
        SoftObstacle& obstacle = around.obstacleOf(soft.step.world.shapes.info[shape].body);
        for (SoftParticle& p : soft.body.particles) {
            if (p.inverseMass > 0.0f) keepOut(soft, p, shape, obstacle);
        }
    }
}

void updateVelocities(const SoftStep& soft) {
    for (SoftParticle& p : soft.body.particles) {
        p.velocity = p.inverseMass > 0.0f ? (p.place - p.before) / soft.h : Vec2{};
        if (!isFinite(p.velocity)) {  // quarantined: it stays where it was
            p.velocity = {};
            p.place = p.before;
        }
    }
}

/// Those that may meet go through their substeps side by side.
void moveGroup(StepContext& step, std::span<const std::uint32_t> group) {
    SoftSoftContacts& meetings = step.work.softSoftContacts;
    SoftSurroundings& around = step.work.softSurroundings;
    int substeps = 1;
    for (const std::uint32_t index : group)
        substeps = std::max<int>(substeps, step.world.softBodies.all[index].substeps);
    findMeetings(step.world, step.dt, group, meetings);
    foresee(step, group);
    const float count = static_cast<float>(substeps), h = step.dt / count;
    for (int i = 0; i < substeps; ++i) {
        const float left = 1.0f - (static_cast<float>(i) + 0.5f) / count;
        const auto softStep = [&](std::uint32_t index) {
            return SoftStep{step, step.world.softBodies.all[index], around.shapesOf(index), h, left};
        };
        moveObstacles(around, h);
        for (const std::uint32_t index : group) {
            const SoftStep soft = softStep(index);
            blow(soft);
            moveFreely(soft);
            keepLengths(soft);
            keepArea(soft);
            keepOutOfAll(soft);
        }
        holdObstacles(around, h);
        keepSoftApart(step.world, h, meetings.all);
        for (const std::uint32_t index : group) updateVelocities(softStep(index));
    }
    pushBodies(step);
}

}  // namespace

/// Position based dynamics with compliance, in small steps. Source: M. Macklin, M. Mueller, N. Chentanez,
/// "XPBD: Position-Based Simulation of Compliant Constrained Dynamics", MIG 2016.
void moveSoftBodies(StepContext& step) {
    SoftSoftContacts& meetings = step.work.softSoftContacts;
    findSurroundings(step);
    groupSoftBodies(step.world, step.dt, step.work.softSurroundings.neighbours, meetings);
    const std::span<const std::uint32_t> order = meetings.order;
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin + 1;
        while (end < order.size() && meetings.leaders[order[end]] == meetings.leaders[order[begin]]) ++end;
        moveGroup(step, order.subspan(begin, end - begin));
        begin = end;
    }
}

}  // namespace plumb::physics
