#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "physics/bounds.hpp"
#include "physics/broadphase/overlap.hpp"
#include "physics/contacts/contacts.hpp"
#include "physics/continuous/swept_bodies.hpp"
#include "physics/edits.hpp"
#include "physics/solver/impact.hpp"
#include "physics/stages.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

constexpr int kSweepGrain = 8;   // searches
constexpr int kFillGrain = 256;  // bodies

// Handling of a hit.

/// True if the solver must handle the hit, because other constraints hold or move the body.
bool needsSolver(const StepContext& step, std::uint32_t body) {
    if (!isDynamic(step.world, body)) return false;
    return step.work.slots[body] < 0 || isHeld(step, body) || hitsOf(step.work, body) >= kMaxImpacts ||
           (step.world.bodies.info[body].flags & (kLockX | kLockY)) != 0;
}

/// Removes the energy that forces added to a held body after the hit (estimate without constraints' work).
void takeBackGain(StepContext& step, const SweptBody& swept, float part) {
    const Float4& drive = step.work.drive[static_cast<std::size_t>(step.work.slots[swept.body])];
    Vec2& velocity = step.world.bodies.motion[swept.body].velocity;
    const float gain = 2.0f * part * dot({drive.x, drive.y}, swept.sweep.displacement);
    const float before = lengthSquared(velocity);
    if (gain > 0.0f) velocity *= std::sqrt(std::max(before - gain, 0.0f) / std::max(before, gain));
}

/// Stops a body at a fraction of its path, with its velocity at this point.
void stop(StepContext& step, std::uint32_t body, const PathHit& hit) {
    const float part = hit.part;
    const std::uint32_t place = step.work.bodyScratch[body];
    if (place == kNone || !isDynamic(step.world, body)) return;
    SweptBody& swept = step.work.swept[place];
    if (swept.isHeld) takeBackGain(step, swept, 1.0f - part);
    step.world.bodies.motion[body].velocity -= ((1.0f - part) * step.dt) * swept.pull;
    swept.sweep = resting(swept.sweep.at(part), part);
    swept.hits = kMaxImpacts + 1;
}

/// Moves a held body together with the kinematic body that hit it to the end of the step, where the solver
/// finds them touching. Left at the position of the hit, it would end up inside or behind the kinematic body.
void carryAlong(StepContext& step, std::uint32_t body, std::uint32_t by, const PathHit& hit, Vec2 normal) {
    const std::uint32_t place = step.work.bodyScratch[body];
    const float left = (1.0f - hit.part) * step.dt;
    if (place == kNone || !isDynamic(step.world, body) || isDynamic(step.world, by) || left <= 0.0f) return;
    const Sweep path = currentPathOf(step, by);
    const BodyPose from = path.at(hit.part), to = path.at(1.0f);
    SweptBody& swept = step.work.swept[place];
    BodyPose pose = swept.sweep.at(1.0f);
    const Vec2 arm = rotate(between(from.rotation, to.rotation), pose.centre - from.centre);
    const Vec2 displacement = (to.centre + arm) - pose.centre;
    const float along = std::max(dot(displacement, normal), 0.0f);
    pose.centre = pose.centre + along * normal;
    swept.sweep = resting(pose, hit.part);
    Vec2& velocity = step.world.bodies.motion[body].velocity;
    velocity += std::max(along / left - dot(velocity, normal), 0.0f) * normal;
}

/// Returns the time (s) from the hit of a surface to the end of the step. The path has constant speed, but
/// the motion is accelerated, so the hit is at a different time than the fraction of the path.
float timeLeft(const SweptBody& swept, Vec2 velocity, Vec2 normal, float left, float dt) {
    const float displacement = (left / dt) * dot(swept.sweep.displacement, normal),
                speed = dot(velocity, normal);
    const float square = speed * speed - 2.0f * dot(swept.pull, normal) * displacement;
    const float sum = speed + std::copysign(std::sqrt(std::max(square, 0.0f)), speed);
    return sum * displacement > 0.0f ? std::min(2.0f * displacement / sum, (1.0f - swept.sweep.begin) * dt)
                                     : left;
}

/// Returns the state of a body at a hit, `left` seconds before the end of the step.
ImpactBody bodyAt(const StepContext& step, std::uint32_t body, const Sweep& sweep, float part, float left) {
    if (!isDynamic(step.world, body))
        return {sweep.at(part), {(1.0f / step.dt) * sweep.displacement, sweep.angle / step.dt}, {}};
    ImpactBody found{sweep.at(part), step.world.bodies.motion[body], step.world.bodies.mass[body]};
    found.motion.velocity -= left * step.work.swept[step.work.bodyScratch[body]].pull;
    return found;
}

/// Continues the motion of a body after a hit.
/// @param out  normal of the static or kinematic surface that it hit, else 0. A body that forces pull onto
///         this surface and that does not leave it in this step stays on it
void sendOn(StepContext& step, std::uint32_t body, const ImpactBody& after, float left, Vec2 out) {
    if (!isDynamic(step.world, body)) return;
    SweptBody& swept = step.work.swept[step.work.bodyScratch[body]];
    const Vec2 velocity = after.motion.velocity;
    const float pull = dot(swept.pull, out);
    if (pull < 0.0f && dot(velocity, out) < -pull * left) swept.pull -= pull * out;
    BodyMotion& motion = step.world.bodies.motion[body];
    motion.velocity = velocity + left * swept.pull + Vec2{};
    motion.angularVelocity = after.motion.angularVelocity + 0.0f;
    swept.sweep =
        sweepThrough(after.pose, 1.0f - left / step.dt, step.dt * (velocity + (0.5f * left) * swept.pull),
                     step.dt * motion.angularVelocity);
    ++swept.hits;
}

/// Returns the contact of a hit, at the poses of the hit.
Contact contactOf(StepContext& step, const PathHit& hit, std::uint32_t own, std::uint32_t other) {
    World& world = step.world;
    Contact contact = makeContact(world, hit.shape, hit.other);
    std::vector<BodyPose>& poses = world.bodies.pose;
    const BodyPose kept[] = {poses[own], poses[other]};
    poses[own] = currentPathOf(step, own).at(hit.part);
    poses[other] = currentPathOf(step, other).at(hit.part);
    findTouch(world, contact, world.bodies.info[own].reach);
    touchUnion(step, contact);
    poses[own] = kept[0];
    poses[other] = kept[1];
    askForMaterial(step, contact);
    if (hit.isPressed) contact.bounciness = 0.0f;
    return contact;
}

/// Handles the next hit on the path of a body.
void hitNext(StepContext& step, std::uint32_t own, std::uint32_t other, const PathHit& hit) {
    Workspace& work = step.work;
    Contact contact = contactOf(step, hit, own, other);
    if (hitsOf(work, own) < kMaxImpacts &&
        !(mayMeet(step, hit.shape, hit.other) && mayPush(step, contact))) {  // a callback lets them pass
        SweptBody& swept = work.swept[work.bodyScratch[own]];
        swept.passed = hit.other;
        swept.sweep.begin = hit.part;
        ++swept.hits;
        return;
    }
    if (contact.count == 0 || needsSolver(step, own) || needsSolver(step, other)) {
        stop(step, own, hit);
        stop(step, other, hit);
        if (contact.count > 0) carryAlong(step, own, other, hit, contact.normal);
        return;
    }
    const bool fixed = !isDynamic(step.world, other);
    if (work.bodyScratch[other] == kNone && !fixed) {
        work.bodyScratch[other] = static_cast<std::uint32_t>(work.swept.size());
        work.swept.push_back(sweptBodyOf(step, other));
        work.sweptProxies.bounds.push_back(pathBounds(step, work.swept.back()));
        work.sweptProxies.filters.push_back({.layers = layerOf(step.world, other)});
        work.sweptProxies.motions.push_back(ProxyMotion::Awake);
    }
    const SweptBody& swept = work.swept[work.bodyScratch[own]];
    float left = (1.0f - hit.part) * step.dt;
    if (fixed) left = timeLeft(swept, step.world.bodies.motion[own].velocity, contact.normal, left, step.dt);
    ImpactBody a = bodyAt(step, contact.bodyA, currentPathOf(step, contact.bodyA), hit.part, left);
    ImpactBody b = bodyAt(step, contact.bodyB, currentPathOf(step, contact.bodyB), hit.part, left);
    noteApproach(step.world, work, contact, a.motion, b.motion);
    exchangeImpulses(contact, a, b, left, step.world.settings);
    const Vec2 out = fixed ? contact.normal : Vec2{};  // A is the static or kinematic body
    sendOn(step, contact.bodyA, a, left, {});
    sendOn(step, contact.bodyB, b, left, out);
    if (!hit.isPressed) work.madeHits.push_back(contact);
}

/// Finds the next hit of a body on its new path.
void lookAgain(StepContext& step, std::uint32_t place) {
    Workspace& work = step.work;
    if (place < work.sweptProxies.bounds.size() && work.sweptProxies.motions[place] != ProxyMotion::Gone) {
        work.sweptProxies.bounds[place] = pathBounds(step, work.swept[place]);
        if (!areFewPaths(work)) work.sweptProxies.search->update(work.sweptProxies.view(), {&place, 1});
    }
    findNextHit(step, place, work.candidates, work.counts);
}

void note(Workspace& work, std::uint32_t place) {
    if (work.swept[place].next.other == kNone) return;
    work.dueHits.emplace_back(work.swept[place].next.part, place);
    std::push_heap(work.dueHits.begin(), work.dueHits.end(), std::greater{});
}

/// Handles all hits of the step in chronological order.
void goThroughHits(StepContext& step) {
    Workspace& work = step.work;
    work.dueHits.clear();
    work.madeHits.clear();
    for (std::uint32_t i = 0; i < work.swept.size(); ++i) note(work, i);
    while (!work.dueHits.empty()) {
        std::pop_heap(work.dueHits.begin(), work.dueHits.end(), std::greater{});
        const auto [part, place] = work.dueHits.back();
        work.dueHits.pop_back();
        const PathHit hit = work.swept[place].next;
        if (hit.part != part) continue;  // superseded by another hit
        const std::uint32_t own = work.swept[place].body, other = step.world.shapes.info[hit.other].body;
        const bool isCurrent = hit.otherHits == hitsOf(work, other);
        if (isCurrent) hitNext(step, own, other, hit);
        lookAgain(step, place);
        if (const std::uint32_t index = work.bodyScratch[other]; isCurrent && index != kNone) {
            lookAgain(step, index);
            note(work, index);
        }
        note(work, place);
    }
}

/// Adds the contacts of hits to the world, with events.
void beginHits(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    auto& order = work.hitOrder;
    order.clear();
    for (std::size_t i = 0; i < work.madeHits.size(); ++i)
        order.emplace_back(pairKey(work.madeHits[i].shapeA, work.madeHits[i].shapeB), i);
    if (order.empty()) return;
    std::sort(order.begin(), order.end());
    const auto begin = [&](std::size_t index, const Contact& contact) {
        world.contacts[index] = contact;
        addKeys(world, work);
        beginContact(world, work, index);
        work.contactKeys[index] = keyOf(world.contacts[index]);
        if (work.stepImpulses.size() <= index) work.stepImpulses.resize(index + 1);
        work.stepImpulses[index] = std::fabs(contact.impulse0) + std::fabs(contact.impulse1);
    };
    const auto mayBegin = [&](std::size_t i) {
        const Contact& contact = world.contacts[i];
        return work.bodyScratch[contact.bodyB] != kNone && (contact.flags & kTouching) == 0;
    };
    forEachIf(step, world.contacts.size(), mayBegin, [&](std::uint32_t i) {
        const PairKey key = pairKey(world.contacts[i].shapeA, world.contacts[i].shapeB);
        const auto hit = std::lower_bound(order.begin(), order.end(), std::pair{key, std::size_t{0}});
        if (hit != order.end() && hit->first == key) begin(i, work.madeHits[hit->second]);
    });
    for (const auto& [pair, place] : order) {
        if (work.pairs.has(pair)) continue;
        work.pairs.add(pair);
        world.contacts.emplace_back();
        begin(world.contacts.size() - 1, work.madeHits[place]);
    }
}

/// Sets the poses of bodies with hits at the end of the step.
void placeHitBodies(StepContext& step) {
    World& world = step.world;
    Shapes& shapes = world.shapes;
    for (const SweptBody& swept : step.work.swept) {
        if (swept.hits == 0) continue;
        world.bodies.pose[swept.body] = swept.sweep.at(1.0f);
        if (isDynamic(world, swept.body)) limitMotion(world, swept.body);
        forShapesOf(world, swept.body, [&](std::uint32_t s) {
            shapes.bounds[s] = grown(tightBounds(world, s), shapes.info[s].margin);
            noteChanged(world, s);
            noteMoved(world, s);
        });
    }
}

/// Prepares the swept bodies of the step, and a broad phase of the bounds of their paths: bullets search for
/// all moving bodies, other bodies for kinematic ones.
void fillSwept(StepContext& step, bool hasKinematics, bool hasBullets) {
    Workspace& work = step.work;
    work.bodyScratch.assign(step.world.bodies.size(), kNone);
    work.swept.resize(work.fastBodies.size());
    BoxProxies& proxies = work.sweptProxies;
    const std::size_t searched = hasKinematics || hasBullets ? work.swept.size() : 0;
    proxies.bounds.assign(searched, kNowhere);
    proxies.filters.assign(searched, {});
    proxies.motions.assign(searched, ProxyMotion::Gone);
    forEach(step.pool, work.swept.size(), kFillGrain, [&](std::size_t i) {
        work.bodyScratch[work.fastBodies[i]] = static_cast<std::uint32_t>(i);
        work.swept[i] = sweptBodyOf(step, work.fastBodies[i]);
        const std::uint32_t layer = layerOf(step.world, work.fastBodies[i]);
        if (searched == 0 || (!hasBullets && layer == kFastLayer)) return;
        proxies.bounds[i] = pathBounds(step, work.swept[i]);
        proxies.filters[i].layers = layer;
        proxies.motions[i] = ProxyMotion::Awake;
    });
    if (searched == 0 || areFewPaths(work)) return;
    if (proxies.search == nullptr) proxies.search = makeBroadPhase(BroadPhaseKind::Tree);
    proxies.search->rebuild(proxies.view());
}

/// Adds bodies that a fast kinematic body may have passed through.
void addPassedBodies(StepContext& step) {
    const World& world = step.world;
    Workspace& work = step.work;
    std::vector<std::uint32_t>& passed = work.passedBodies;
    passed.clear();
    std::vector<std::uint32_t>& known = work.bodyScratch;
    known.assign(world.bodies.size(), kNone);
    for (const std::uint32_t body : work.fastBodies) known[body] = 0;
    for (const std::uint32_t body : work.fastBodies) {
        if (isDynamic(world, body)) continue;
        const Sweep path = pathOf(step, body);
        const BodyInfo& info = world.bodies.info[body];
        if (!isFast(path.displacement, path.angle, info)) continue;
        work.candidates.clear();
        work.broadPhase->cast(toVec2(path.start), path.displacement, {info.reach, info.reach}, 0xffffffffu,
                              work.candidates, Among::All);
        const auto bodyAt = [&](std::size_t i) { return world.shapes.info[work.candidates[i]].body; };
        const auto isPassed = [&](std::size_t i) {
            const std::uint32_t other = bodyAt(i);
            return known[other] == kNone && isDynamic(world, other) && work.slots[other] >= 0 &&
                   isFastBeside(pathOf(step, other), path, world.bodies.info[other]);
        };
        forEachIf(step, work.candidates.size(), isPassed, [&](std::uint32_t i) {
            if (std::exchange(known[bodyAt(i)], 0) == kNone) passed.push_back(bodyAt(i));
        });
    }
    work.fastBodies.insert(work.fastBodies.end(), passed.begin(), passed.end());
    if (!passed.empty()) std::sort(work.fastBodies.begin(), work.fastBodies.end());
}

}  // namespace

// Continuous collision detection: sweeps fast bodies along their paths. If a free body hits a static or
// kinematic one, or a bullet hits another free body, the impulses of the impact act at this time and both
// continue for the rest of the step. A body held by contacts or joints stops at the hit with its velocity
// there: the solver has to handle the hit together with these constraints, in the next step.
void sweepFastBodies(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    work.swept.clear();
    if (step.runs(Effect::Kinematics)) {
        updateBroadPhase(world, work);
        addPassedBodies(step);
    }
    const auto some = [&](auto&& is) {
        return std::any_of(work.fastBodies.begin(), work.fastBodies.end(), is);
    };
    const bool moves = some([&](std::uint32_t body) { return isDynamic(world, body); });
    if (!moves || !step.runs(Effect::Contacts)) return;  // no bodies, or no contacts
    // Moving kinematic bodies are in fastBodies; the broad phase must find only those at rest.
    const auto moving = std::count_if(work.fastBodies.begin(), work.fastBodies.end(),
                                      [&](std::uint32_t body) { return !isDynamic(world, body); });
    work.kinematicsAtRest = static_cast<std::uint32_t>(moving) <
                            world.manifest.requesters[static_cast<std::size_t>(Effect::Kinematics)];
    const bool hasBullets = some([&](std::uint32_t body) { return layerOf(world, body) == kBulletLayer; });
    if (moving > 0 || hasBullets) updateBroadPhase(world, work);
    fillSwept(step, moving > 0, hasBullets);
    forPieces(step.pool, work.swept.size(), kSweepGrain, work.sweepFindings,
              [&](std::size_t begin, std::size_t end, SweepFindings& found) {
                  for (std::size_t i = begin; i < end; ++i) findNextHit(step, i, found.shapes, found.counts);
              });
    for (const SweepFindings& found : work.sweepFindings) work.counts += found.counts;
    goThroughHits(step);
    placeHitBodies(step);
    beginHits(step);
}

}  // namespace plumb::physics
