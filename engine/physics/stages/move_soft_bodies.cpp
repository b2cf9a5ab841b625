#include <algorithm>

#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

struct SoftStep {
    const StepContext& step;
    SoftBody& body;
    float h;  // s
};

/// Returns a particle's velocity, limited to the maximum speed; 0 if it is not finite.
Vec2 allowed(const SoftStep& soft, Vec2 velocity) {
    const float maximum = soft.step.world.settings.maxSpeed, speed = length(velocity);
    if (speed <= maximum) return velocity;
    if (std::isfinite(speed)) return (maximum / speed) * velocity;
    const auto index = static_cast<std::uint32_t>(&soft.body - soft.step.world.softBodies.all.data());
    const SoftBodyId id{index, soft.body.generation};
    std::vector<SoftBodyId>& all = soft.step.world.quarantinedSoft;
    if (std::find(all.begin(), all.end(), id) == all.end()) all.push_back(id);
    return {};
}

/// Applies wind to the particles. The width of a particle is the length of a link.
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
    for (SoftParticle& p : soft.body.particles) {
        p.before = p.place;
        if (p.inverseMass == 0.0f) continue;
        p.velocity = allowed(soft, kept * (p.velocity + soft.h * pull));
        p.place = p.place + soft.h * p.velocity;
    }
}

/// Length constraints C = |b - a| - length. One iteration, so the multiplier starts at 0 (XPBD, Eq. 18).
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

/// Area constraint C = area - rest area. Gradient: half the vector between both neighbours, rotated by 90°.
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
    // Gradients use the positions before this loop, so `first` and `last` store old positions.
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

void updateVelocities(const SoftStep& soft) {
    for (SoftParticle& p : soft.body.particles) {
        const Vec2 velocity = p.inverseMass > 0.0f ? (p.place - p.before) / soft.h : Vec2{};
        p.velocity = allowed(soft, velocity);
        if (!(p.velocity == velocity)) p.place = p.before + soft.h * p.velocity;
    }
}

/// Calls act(SoftStep) with the soft bodies of a group.
template <class Act>
void forSoft(const StepContext& step, const SoftGroup& group, float h, Act&& act) {
    for (const std::uint32_t index : group.bodies.of(step.work.softSoftContacts.order))
        act(SoftStep{step, step.world.softBodies.all[index], h});
}

/// Steps a group that cannot push any rigid body.
void moveAlone(StepContext& step, const SoftGroup& group) {
    const float h = step.dt / static_cast<float>(group.substeps);
    const ContactPass pass = contactPass(step.world.settings, h);
    for (int i = 0; i < group.substeps; ++i) {
        springSoft(step, group, h, i);
        solveSoft(step, group, pass, false);
        closeSoft(step, group, h);
        solveSoft(step, group, pass, true);
    }
    finishSoft(step, group, h);
}

}  // namespace

void springSoft(StepContext& step, const SoftGroup& group, float h, int substep) {
    measureSoftContacts(step, group, h * static_cast<float>(substep));
    forSoft(step, group, h, [](const SoftStep& soft) {
        blow(soft);
        moveFreely(soft);
        keepLengths(soft);
        keepArea(soft);
    });
    warmStartSoft(step, group, h, substep == 0);
    keepSoftApart(step.world, h, group.meetings.of(step.work.softSoftContacts.all));
}

void closeSoft(const StepContext& step, const SoftGroup& group, float h) {
    forSoft(step, group, h, updateVelocities);
}

void finishSoft(StepContext& step, const SoftGroup& group, float h) {
    forSoft(step, group, h, [](const SoftStep& soft) {
        for (SoftParticle& p : soft.body.particles) p.velocity = allowed(soft, p.velocity);
    });
    storeSoftContacts(step, group, h);
}

/// Position-based dynamics with compliance, in small substeps. Soft bodies that may touch are stepped
/// together; those that may push islands are stepped with them, in solve(). Source: M. Macklin, M. Mueller,
/// N. Chentanez, "XPBD: Position-Based Simulation of Compliant Constrained Dynamics", MIG 2016.
void moveSoftBodies(StepContext& step) {
    SoftSoftContacts& meetings = step.work.softSoftContacts;
    findSurroundings(step);
    groupSoftBodies(step.world, step.dt, step.work.softSurroundings, meetings);
    const std::span<const std::uint32_t> order = meetings.order;
    meetings.all.clear();
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin + 1;
        while (end < order.size() && meetings.leaders[order[end]] == meetings.leaders[order[begin]]) ++end;
        SoftGroup& group = step.work.softSurroundings.groups.emplace_back();
        group.bodies = {begin, end};
        group.meetings.begin = meetings.all.size();
        findMeetings(step.world, step.dt, group.bodies.of(meetings.order), meetings);
        group.meetings.end = meetings.all.size();
        findSoftContacts(step, group);
        group.substeps = substepsOf(step, group);
        if (group.body == kNone) moveAlone(step, group);
        begin = end;
    }
}

}  // namespace plumb::physics
