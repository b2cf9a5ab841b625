#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "math/portable.hpp"
#include "physics/broadphase_update.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/sleeping.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// m/s: a particle this fast wakes what it hits.
constexpr float kRousing = 0.5f;

/// One soft body in one substep.
struct SoftStep {
    World& world;
    SoftBody& body;
    std::span<const std::uint32_t> shapes;  // near it
    float h;                                // s
    float elapsed;                          // s since the start of the step
};

/// Each particle is as wide in the wind as the way to its neighbour.
void blowOn(const SoftStep& soft, const FieldDefinition& wind) {
    if ((wind.layers & soft.body.layers) == 0) return;
    const Vec2 air = airOf(wind, soft.world.steps);
    const float width = soft.body.links.empty() ? 2.0f * soft.body.radius : soft.body.links.front().length;
    for (SoftParticle& p : soft.body.particles) {
        if (p.inverseMass == 0.0f || !isInRegion(wind, p.place)) continue;
        const Vec2 felt = air - p.velocity;
        const float rate = wind.density * width * length(felt) * p.inverseMass;  // 1/s
        p.velocity += std::min(rate * soft.h, 1.0f) * felt;
    }
}

void blow(const SoftStep& soft) {
    if (!soft.world.manifest.runs(Effect::Wind)) return;
    for (const Field& field : soft.world.fields.all) {
        if (field.isAlive && field.definition.kind == FieldKind::Wind) blowOn(soft, field.definition);
    }
}

void moveFreely(const SoftStep& soft) {
    const bool pulled = (soft.world.manifest.pinnedOff & Manifest::bit(Effect::Gravity)) == 0;
    const Vec2 pull = pulled ? soft.world.settings.gravity : Vec2{};
    const float kept = exponential(-soft.body.damping * soft.h);
    const float most = soft.world.settings.maxSpeed;
    for (SoftParticle& p : soft.body.particles) {
        p.before = p.place;
        if (p.inverseMass == 0.0f) continue;
        p.velocity = kept * (p.velocity + soft.h * pull);
        const float speed = length(p.velocity);
        if (!(speed <= most)) p.velocity = std::isfinite(speed) ? (most / speed) * p.velocity : Vec2{};
        p.place = p.place + soft.h * p.velocity;
    }
}

/// C = |b - a| - length. One iteration a substep, so the multiplier starts at 0 (XPBD, Eq. 18).
void keepLengths(const SoftStep& soft) {
    const float perStep = 1.0f / (soft.h * soft.h);
    for (const SoftLink& link : soft.body.links) {
        SoftParticle& a = soft.body.particles[link.a];
        SoftParticle& b = soft.body.particles[link.b];
        const Vec2 way = b.place - a.place;
        const float size = length(way), weight = a.inverseMass + b.inverseMass;
        if (size <= 0.0f || weight <= 0.0f) continue;
        const Vec2 push = (-(size - link.length) / (weight + link.compliance * perStep) / size) * way;
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
    const Place origin = particles[ring[0]].place;
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

/// A shape's body as a particle meets it.
struct Obstacle {
    Place centre;  // m, now
    float inverseMass = 0.0f;
    float inverseInertia = 0.0f;
    bool rests = false;
};

Obstacle obstacleOf(const SoftStep& soft, std::uint32_t body) {
    const World& world = soft.world;
    const BodyInfo& info = world.bodies.info[body];
    Obstacle obstacle{world.bodies.pose[body].centre + soft.elapsed * world.bodies.motion[body].velocity};
    obstacle.rests = info.kind == BodyKind::Dynamic && info.place == kNone;
    if (info.kind == BodyKind::Dynamic && !obstacle.rests) {
        obstacle.inverseMass = world.bodies.mass[body].inverseMass;
        obstacle.inverseInertia = world.bodies.mass[body].inverseInertia;
    }
    return obstacle;
}

void pushBody(World& world, std::uint32_t body, const Obstacle& obstacle, Vec2 arm, Vec2 impulse) {
    BodyMotion& motion = world.bodies.motion[body];
    motion.velocity += obstacle.inverseMass * impulse;
    motion.angularVelocity += obstacle.inverseInertia * cross(arm, impulse);
}

/// Pushes a particle out of a shape, and the shape's body away from the particle.
void keepOut(const SoftStep& soft, SoftParticle& p, std::uint32_t shape) {
    World& world = soft.world;
    const std::uint32_t body = world.shapes.info[shape].body;
    const Obstacle obstacle = obstacleOf(soft, body);
    const BodyPose& pose = world.bodies.pose[body];
    const Vec2 arm = p.place - obstacle.centre;
    const ClosestPoint nearest = closestPoint(world.shapes.geometry[shape], world.shapes.corners,
                                              pose.localCentre + unrotate(pose.rotation, arm));
    const float depth = soft.body.radius - nearest.distance;
    if (!(depth > 0.0f)) return;
    const Vec2 normal = rotate(pose.rotation, nearest.normal);
    const float lever = cross(arm, normal);
    const float weight = p.inverseMass + obstacle.inverseMass + obstacle.inverseInertia * lever * lever;
    if (weight <= 0.0f) return;
    const float push = depth / weight;
    p.place = p.place + (push * p.inverseMass) * normal;
    const BodyMotion& motion = world.bodies.motion[body];
    const Vec2 surface = motion.velocity + cross(motion.angularVelocity, arm);
    const Vec2 slid = (p.place - p.before) - soft.h * surface;
    const Vec2 along = perpendicular(normal);
    const float slip = std::clamp(dot(slid, along), -soft.body.friction * depth, soft.body.friction * depth);
    p.place = p.place + -(p.inverseMass / weight * slip) * along;
    pushBody(world, body, obstacle, arm, (-push / soft.h) * normal + (slip / (weight * soft.h)) * along);
    if (obstacle.rests && length(p.velocity) > kRousing) wake(world, body);
}

void keepOutOfAll(const SoftStep& soft) {
    for (SoftParticle& p : soft.body.particles) {
        if (p.inverseMass == 0.0f) continue;
        for (const std::uint32_t shape : soft.shapes) keepOut(soft, p, shape);
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

AABB boundsOf(const SoftBody& body, float dt) {
    constexpr float kFar = std::numeric_limits<float>::max();
    AABB bounds{{kFar, kFar}, {-kFar, -kFar}};
    for (const SoftParticle& p : body.particles) {
        const Vec2 here = toVec2(p.place), there = toVec2(p.place + dt * p.velocity);
        bounds = {min(bounds.min, min(here, there)), max(bounds.max, max(here, there))};
    }
    return grown(bounds, 2.0f * body.radius);
}

/// Puts the shapes near a soft body behind those of others.
void findShapes(StepContext& step, const SoftBody& body) {
    const Shapes& shapes = step.world.shapes;
    std::vector<std::uint32_t>& found = step.work.softShapes;
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    if (step.work.broadPhase != nullptr) {
        step.work.broadPhase->query(proxiesOf(step.world), boundsOf(body, step.dt), body.mask, found);
    }
    const auto end = std::remove_if(found.begin() + first, found.end(), [&](std::uint32_t shape) {
        return (shapes.info[shape].flags & kTrigger) != 0 || (shapes.filter[shape].mask & body.layers) == 0;
    });
    found.erase(end, found.end());
    std::sort(found.begin() + first, found.end());
    step.work.softShapeEnds.push_back(static_cast<std::uint32_t>(found.size()));
}

/// Does something to each soft body of a group in the `index`th of `substeps`.
template <class Act>
void forSoftBodies(StepContext& step, std::span<const std::uint32_t> group, int substeps, int index,
                   Act&& act) {
    const float h = step.dt / static_cast<float>(substeps);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
        const std::size_t end = step.work.softShapeEnds[i];
        act(SoftStep{step.world, step.world.softBodies.all[group[i]],
                     std::span{step.work.softShapes}.subspan(begin, end - begin), h,
                     h * static_cast<float>(index)});
        begin = end;
    }
}

/// Those that may meet go through their substeps side by side.
void moveGroup(StepContext& step, std::span<const std::uint32_t> group) {
    SoftMeetings& meetings = step.work.softMeetings;
    step.work.softShapes.clear();
    step.work.softShapeEnds.clear();
    int substeps = 1;
    for (const std::uint32_t index : group) {
        const SoftBody& body = step.world.softBodies.all[index];
        findShapes(step, body);
        substeps = std::max<int>(substeps, body.substeps);
    }
    findMeetings(step.world, step.dt, group, meetings);
    for (int i = 0; i < substeps; ++i) {
        forSoftBodies(step, group, substeps, i, [](const SoftStep& soft) {
            blow(soft);
            moveFreely(soft);
            keepLengths(soft);
            keepArea(soft);
            keepOutOfAll(soft);
        });
        keepSoftApart(step.world, step.dt / static_cast<float>(substeps), meetings.all);
        forSoftBodies(step, group, substeps, i, updateVelocities);
    }
}

}  // namespace

/// Position based dynamics with compliance, in small steps. Source: M. Macklin, M. Mueller, N. Chentanez,
/// "XPBD: Position-Based Simulation of Compliant Constrained Dynamics", MIG 2016.
void moveSoftBodies(StepContext& step) {
    SoftMeetings& meetings = step.work.softMeetings;
    groupSoftBodies(step.world, step.dt, meetings);
    const std::span<const std::uint32_t> order = meetings.order;
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin + 1;
        while (end < order.size() && meetings.leaders[order[end]] == meetings.leaders[order[begin]]) ++end;
        moveGroup(step, order.subspan(begin, end - begin));
        begin = end;
    }
}

}  // namespace plumb::physics
