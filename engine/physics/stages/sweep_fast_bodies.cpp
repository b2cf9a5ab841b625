#include <algorithm>
#include <cmath>
#include <functional>

#include "physics/broadphase/broadphase_update.hpp"
#include "physics/contacts/contacts.hpp"
#include "physics/model/bounds.hpp"
#include "physics/solver/impact.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kGrain = 8;

/// Hits that change the path of a body within one step; at one more it stops, and the next step goes on with
/// it. What comes into a corner of an angle of a leaves it after at most 1 + pi / a elastic hits: 5 are
/// enough for 45 degrees.
constexpr int kMaxHits = 5;

/// What gets no further than this part of its path is wedged: it reaches into something already, and turns
/// under it faster than its contact can follow. Else it would stay there at full speed.
constexpr float kWedged = 0.02f;
constexpr float kKeptWhenWedged = 0.5f;  // of its speeds

/// Layers of Workspace::sweptProxies: bullets search for all of them, other bodies for some.
constexpr std::uint32_t kBulletLayer = 1, kFastLayer = 2, kKinematicLayer = 4;

Rot turnOf(const Float4& deltaPosition) { return normalized(Rot{1.0f + deltaPosition.w, deltaPosition.z}); }

bool isDynamic(const World& world, std::uint32_t body) {
    return world.bodies.info[body].kind == BodyKind::Dynamic;
}
bool isBullet(const World& world, std::uint32_t body) {
    return (world.bodies.info[body].flags & kBullet) != 0;
}
/// By contacts or joints.
bool isHeld(const StepContext& step, std::uint32_t body) { return step.work.colourMasks[body] != 0; }

/// How a body has come through this step: from where it is now and how far it was shifted.
Sweep pathOf(const StepContext& step, std::uint32_t body) {
    const BodyPose& pose = step.world.bodies.pose[body];
    const auto slot = static_cast<std::size_t>(step.work.slots[body]);
    const Float4& deltaPosition = step.work.deltaPosition[slot];
    const Vec2 displacement{deltaPosition.x, deltaPosition.y};
    Sweep sweep{pose.centre + -displacement, displacement, pose.rotation, 0.0f, pose.localCentre};
    if (deltaPosition.z == 0.0f && step.work.velocity[slot].z == 0.0f) return sweep;
    const float angle = angleOf(turnOf(deltaPosition));
    const float turns = (step.work.velocity[slot].z * step.dt - angle) / kTau;
    sweep.turn = angle + kTau * static_cast<float>(floorToInt(turns + 0.5f));
    sweep.rotation = normalized(inverse(turnOf(deltaPosition)) * pose.rotation);
    return sweep;
}

/// The path of what may be in the way. What does not move or is held is slow: it is met where it is.
Sweep pathOfMet(const StepContext& step, std::uint32_t body) {
    const Workspace& work = step.work;
    if (const std::uint32_t place = work.bodyScratch[body]; place != kNone) return work.swept[place].sweep;
    const bool stays = !isDynamic(step.world, body) || work.slots[body] < 0 || isHeld(step, body);
    return stays ? resting(step.world.bodies.pose[body]) : pathOf(step, body);
}

SweptBody sweptBodyOf(const StepContext& step, std::uint32_t body) {
    SweptBody swept;
    swept.body = body;
    swept.sweep = pathOf(step, body);
    swept.isHeld = isDynamic(step.world, body) && isHeld(step, body);
    if (!isDynamic(step.world, body) || swept.isHeld) return swept;
    // Its path would be longer at the velocity of its end, by what made it faster.
    const Vec2 velocity = step.world.bodies.motion[body].velocity;
    swept.pull = (2.0f / step.dt) * (velocity - (1.0f / step.dt) * swept.sweep.displacement);
    return swept;
}

// To find hits.

/// Whether a body may pass something thin that moves along `path`: what lies in a drum does not, however fast
/// the drum rotates.
bool isFastBeside(const Sweep& own, const Sweep& path, const BodyInfo& info) {
    constexpr float kWide = 1.0f;  // rad: beyond it the chord of a rotation is much shorter than its arc
    if (path.turn == 0.0f) return isFast(own.displacement - path.displacement, own.turn, info);
    const Vec2 arm = own.start - path.start;
    const Vec2 carried = path.displacement + rotate(rotFromAngle(path.turn), arm) - arm;
    return std::fabs(path.turn) > kWide || isFast(own.displacement - carried, own.turn - path.turn, info);
}

/// Half the side of a square that contains the body at any angle, and the gap that it keeps (m).
float reachOf(const StepContext& step, const SweptBody& swept) {
    const Vec2 from = toVec2(swept.sweep.start);
    const float rounding = 5.0e-7f * std::max(std::fabs(from.x), std::fabs(from.y));
    return step.world.bodies.info[swept.body].reach + rounding + step.world.settings.speculativeDistance;
}
Vec2 beginOf(const Sweep& sweep) { return toVec2(sweep.start + sweep.displacement * sweep.begin); }
Vec2 displacementLeft(const Sweep& sweep) { return sweep.displacement * std::max(1.0f - sweep.begin, 0.0f); }

int hitsOf(const Workspace& work, std::uint32_t body) {
    const std::uint32_t place = work.bodyScratch[body];
    return place == kNone ? 0 : work.swept[place].hits;
}

/// Finds what a body hits next. Searches give what is near in an order of their own; of two hits at one time
/// that of the lower number counts.
void findNext(const StepContext& step, std::size_t place, std::vector<std::uint32_t>& found,
              DetectionCounts& counts) {
    const World& world = step.world;
    const Workspace& work = step.work;
    SweptBody& swept = step.work.swept[place];
    const Sweep& sweep = swept.sweep;
    swept.next = {};
    if (!isDynamic(world, swept.body) || swept.hits > kMaxHits || sweep.begin >= 1.0f) return;
    const auto meetAll = [&](std::uint32_t shape) {
        if (shape == swept.passed) return;
        const Sweep path = pathOfMet(step, world.shapes.info[shape].body);
        if (swept.hits == 0 && !isFastBeside(sweep, path, world.bodies.info[swept.body])) return;
        for (std::uint32_t s = world.bodies.info[swept.body].firstShape; s != kNone;
             s = world.shapes.info[s].next) {
            ++counts.swept;
            meetOnPath(world, {s, sweep, !swept.isHeld}, {shape, path}, swept.next);
        }
    };
    const float reach = reachOf(step, swept);
    const bool all = isBullet(world, swept.body);
    found.clear();
    work.broadPhase->cast(proxiesOf(world), beginOf(sweep), displacementLeft(sweep), {reach, reach},
                          0xffffffffu, found,
                          all || world.manifest.runs(Effect::Kinematics) ? Among::All : Among::Static);
    std::sort(found.begin(), found.end());
    for (const std::uint32_t shape : found) {
        const std::uint32_t body = world.shapes.info[shape].body;
        if (work.bodyScratch[body] == kNone && (all || !isDynamic(world, body))) meetAll(shape);
    }
    if (work.sweptProxies.bounds.empty()) return;
    // Bullets meet everything. What a hit sent another way meets the bullets, which looked at its first path.
    const std::uint32_t layers =
        kKinematicLayer | (all || swept.hits > 0 ? kBulletLayer : 0) | (all ? kFastLayer : 0);
    found.clear();
    work.sweptProxies.search->cast(work.sweptProxies.view(), beginOf(sweep), displacementLeft(sweep),
                                   {reach, reach}, layers, found, Among::All);
    std::sort(found.begin(), found.end());
    for (const std::uint32_t other : found) {
        for (std::uint32_t s = world.bodies.info[work.swept[other].body].firstShape; s != kNone;
             s = world.shapes.info[s].next)
            meetAll(s);
    }
    if (swept.next.met != kNone) swept.next.metHits = hitsOf(work, world.shapes.info[swept.next.met].body);
}

// What happens at a hit.

/// Whether the solver has to see the hit, together with what else holds or moves the body.
bool needsSolver(const StepContext& step, std::uint32_t body) {
    if (!isDynamic(step.world, body)) return false;
    return step.work.slots[body] < 0 || isHeld(step, body) || hitsOf(step.work, body) >= kMaxHits ||
           (step.world.bodies.info[body].flags & (kLockX | kLockY)) != 0;
}

/// Takes from a held body the energy that it gained on the part of its path that it is set back by, as far as
/// is known: what holds it pulls too.
void takeBackGain(StepContext& step, const SweptBody& swept, float part) {
    const Float4& drive = step.work.drive[static_cast<std::size_t>(step.work.slots[swept.body])];
    Vec2& velocity = step.world.bodies.motion[swept.body].velocity;
    const float gain = 2.0f * part * dot({drive.x, drive.y}, swept.sweep.displacement);
    const float before = lengthSquared(velocity);
    if (gain > 0.0f) velocity *= std::sqrt(std::max(before - gain, 0.0f) / std::max(before, gain));
}

/// Leaves a body where it is at a part of the step, with the velocity that it has there.
void stop(StepContext& step, std::uint32_t body, const PathHit& hit) {
    const float part = hit.part;
    const std::uint32_t place = step.work.bodyScratch[body];
    if (place == kNone || !isDynamic(step.world, body)) return;
    SweptBody& swept = step.work.swept[place];
    BodyMotion& motion = step.world.bodies.motion[body];
    if (swept.isHeld) takeBackGain(step, swept, 1.0f - part);
    motion.velocity -= ((1.0f - part) * step.dt) * swept.pull;
    if (hit.isPressed && part - swept.sweep.begin < kWedged) {
        motion.velocity *= kKeptWhenWedged;
        motion.angularVelocity *= kKeptWhenWedged;
    }
    swept.sweep = resting(swept.sweep.at(part), part);
    swept.hits = kMaxHits + 1;
}

/// Takes a held body that a kinematic one hit along with that to the end of the step, where the solver finds
/// them touching: left where it was hit, the kinematic body would pass it.
void carryAlong(StepContext& step, std::uint32_t body, std::uint32_t by, const PathHit& hit, Vec2 normal) {
    const std::uint32_t place = step.work.bodyScratch[body];
    const float left = (1.0f - hit.part) * step.dt;
    if (place == kNone || !isDynamic(step.world, body) || isDynamic(step.world, by) || left <= 0.0f) return;
    const Sweep path = pathOfMet(step, by);
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

/// s: how long before the end of the step a body was at the place where it hits a surface that does not
/// yield. Its path is straight and its flight was not: along the normal it was there at another moment.
float timeLeft(const SweptBody& swept, Vec2 velocity, Vec2 normal, float left, float dt) {
    const float displacement = (left / dt) * dot(swept.sweep.displacement, normal),
                speed = dot(velocity, normal);
    const float square = speed * speed - 2.0f * dot(swept.pull, normal) * displacement;
    const float sum = speed + std::copysign(std::sqrt(std::max(square, 0.0f)), speed);
    return sum * displacement > 0.0f ? std::min(2.0f * displacement / sum, (1.0f - swept.sweep.begin) * dt)
                                     : left;
}

/// A body at the moment of a hit, so many s before the end of the step.
ImpactBody bodyAt(const StepContext& step, std::uint32_t body, const Sweep& sweep, float part, float left) {
    const World& world = step.world;
    if (!isDynamic(world, body))
        return {sweep.at(part), {(1.0f / step.dt) * sweep.displacement, sweep.turn / step.dt}, {}};
    ImpactBody found{sweep.at(part), world.bodies.motion[body], world.bodies.mass[body]};
    found.motion.velocity -= left * step.work.swept[step.work.bodyScratch[body]].pull;
    return found;
}

/// Sends a body on after a hit.
/// @param out  of what it hit if that never yields, else 0: what is pulled onto a surface that it does not
///             leave any more in this step stays there
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

/// The contact of a hit, at its moment.
Contact contactOf(StepContext& step, const PathHit& hit, std::uint32_t own, std::uint32_t met) {
    World& world = step.world;
    Contact contact = makeContact(world, hit.shape, hit.met);
    std::vector<BodyPose>& poses = world.bodies.pose;
    const BodyPose kept[] = {poses[own], poses[met]};
    poses[own] = pathOfMet(step, own).at(hit.part);
    poses[met] = pathOfMet(step, met).at(hit.part);
    findTouch(world, contact, world.bodies.info[own].reach);
    poses[own] = kept[0];
    poses[met] = kept[1];
    if (hit.isPressed) contact.bounciness = 0.0f;
    return contact;
}

std::uint32_t layerOf(const World& world, std::uint32_t body) {
    if (!isDynamic(world, body)) return kKinematicLayer;
    return isBullet(world, body) ? kBulletLayer : kFastLayer;
}

AABB boundsOf(const StepContext& step, const SweptBody& swept) {
    const float reach = reachOf(step, swept);
    const Vec2 from = beginOf(swept.sweep), to = from + displacementLeft(swept.sweep), half{reach, reach};
    return {min(from, to) - half, max(from, to) + half};
}

void addProxy(const StepContext& step, const SweptBody& swept) {
    SweptProxies& proxies = step.work.sweptProxies;
    proxies.bounds.push_back(boundsOf(step, swept));
    proxies.filters.push_back({.layers = layerOf(step.world, swept.body)});
    proxies.motions.push_back(ProxyMotion::Awake);
}

/// Whether the owner of the world lets these two pass each other.
bool isRefused(const StepContext& step, const PathHit& hit, const Contact& contact) {
    const World& world = step.world;
    const ContactHooks& hooks = step.hooks;
    const auto id = [&](std::uint32_t shape) { return ShapeId{shape, world.shapes.info[shape].generation}; };
    return (hooks.filter != nullptr && !hooks.filter(hooks.context, world, id(hit.shape), id(hit.met))) ||
           (hooks.preSolve != nullptr && !hooks.preSolve(hooks.context, world, contact));
}

/// Lets a body hit what comes next on its path.
void hitNext(StepContext& step, std::uint32_t own, std::uint32_t met, const PathHit& hit) {
    Workspace& work = step.work;
    Contact contact = contactOf(step, hit, own, met);
    if (hitsOf(work, own) < kMaxHits && isRefused(step, hit, contact)) {
        SweptBody& swept = work.swept[work.bodyScratch[own]];
        swept.passed = hit.met;
        swept.sweep.begin = hit.part;
        ++swept.hits;
        return;
    }
    if (contact.count == 0 || needsSolver(step, own) || needsSolver(step, met)) {
        stop(step, own, hit);
        stop(step, met, hit);
        if (contact.count > 0) carryAlong(step, own, met, hit, contact.normal);
        return;
    }
    const bool fixed = !isDynamic(step.world, met);
    if (work.bodyScratch[met] == kNone && !fixed) {
        work.bodyScratch[met] = static_cast<std::uint32_t>(work.swept.size());
        work.swept.push_back(sweptBodyOf(step, met));
        addProxy(step, work.swept.back());
    }
    const SweptBody& swept = work.swept[work.bodyScratch[own]];
    float left = (1.0f - hit.part) * step.dt;
    if (fixed) left = timeLeft(swept, step.world.bodies.motion[own].velocity, contact.normal, left, step.dt);
    ImpactBody a = bodyAt(step, contact.bodyA, pathOfMet(step, contact.bodyA), hit.part, left);
    ImpactBody b = bodyAt(step, contact.bodyB, pathOfMet(step, contact.bodyB), hit.part, left);
    exchangeImpulses(contact, a, b, left, step.world.settings);
    const Vec2 out = fixed ? contact.normal : Vec2{};  // what never yields is A
    sendOn(step, contact.bodyA, a, left, {});
    sendOn(step, contact.bodyB, b, left, out);
    if (!hit.isPressed) work.madeHits.push_back(contact);
}

/// Looks for the next hit of a body on its new path.
void lookAgain(StepContext& step, std::uint32_t place) {
    Workspace& work = step.work;
    if (place < work.sweptProxies.bounds.size()) {
        work.sweptProxies.bounds[place] = boundsOf(step, work.swept[place]);
        work.sweptProxies.search->update(work.sweptProxies.view(), {&place, 1});
    }
    findNext(step, place, work.candidates, work.counts);
}

void note(Workspace& work, std::uint32_t place) {
    if (work.swept[place].next.met == kNone) return;
    work.dueHits.emplace_back(work.swept[place].next.part, place);
    std::push_heap(work.dueHits.begin(), work.dueHits.end(), std::greater{});
}

/// All hits of the step, one after the other.
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
        if (hit.part != part) continue;  // it has hit something else meanwhile
        const std::uint32_t own = work.swept[place].body, met = step.world.shapes.info[hit.met].body;
        const bool isCurrent = hit.metHits == hitsOf(work, met);
        if (isCurrent) hitNext(step, own, met, hit);
        lookAgain(step, place);
        if (const std::uint32_t other = work.bodyScratch[met]; isCurrent && other != kNone) {
            lookAgain(step, other);
            note(work, other);
        }
        note(work, place);
    }
}

/// Contacts of hits are events, and the next step knows of them.
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
        while (work.contactKeys.size() < world.contacts.size())
            work.contactKeys.push_back(keyOf(world.contacts[work.contactKeys.size()]));
        beginContact(world, work, index);
        work.contactKeys[index] = keyOf(world.contacts[index]);
    };
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
        const Contact& contact = world.contacts[i];
        if (work.bodyScratch[contact.bodyB] == kNone || (contact.flags & kTouching) != 0) continue;
        const std::pair pair{pairKey(contact.shapeA, contact.shapeB), std::size_t{0}};
        const auto hit = std::lower_bound(order.begin(), order.end(), pair);
        if (hit != order.end() && hit->first == pair.first) begin(i, work.madeHits[hit->second]);
    }
    for (const auto& [pair, place] : order) {
        if (work.pairs.has(pair)) continue;
        work.pairs.add(pair);
        world.contacts.emplace_back();
        begin(world.contacts.size() - 1, work.madeHits[place]);
    }
}

/// Where the bodies that hit something are at the end of the step.
void placeHitBodies(StepContext& step) {
    World& world = step.world;
    Shapes& shapes = world.shapes;
    for (const SweptBody& swept : step.work.swept) {
        if (swept.hits == 0) continue;
        world.bodies.pose[swept.body] = swept.sweep.at(1.0f);
        for (std::uint32_t s = world.bodies.info[swept.body].firstShape; s != kNone;
             s = shapes.info[s].next) {
            shapes.bounds[s] = grown(tightBounds(world, s), shapes.info[s].margin);
            noteChanged(world, s);
            noteMoved(world, s);
        }
    }
}

/// Takes the fast bodies of the step. What they may meet while it moves too is found by the bounds of its
/// path.
/// @param together  whether there is any such
void fillSwept(StepContext& step, bool together) {
    Workspace& work = step.work;
    work.bodyScratch.assign(step.world.bodies.size(), kNone);
    work.swept.clear();
    for (const std::uint32_t body : work.fastBodies) {
        work.bodyScratch[body] = static_cast<std::uint32_t>(work.swept.size());
        work.swept.push_back(sweptBodyOf(step, body));
    }
    SweptProxies& proxies = work.sweptProxies;
    proxies.bounds.clear();
    proxies.filters.clear();
    proxies.motions.clear();
    if (!together) return;
    for (const SweptBody& swept : work.swept) addProxy(step, swept);
    if (proxies.search == nullptr) proxies.search = makeBroadPhase(BroadPhaseKind::Tree);
    proxies.search->rebuild(proxies.view());
}

/// Adds the bodies that a fast kinematic body may have passed: seen from that, they are as fast.
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
        if (!isFast(path.displacement, path.turn, info)) continue;
        work.candidates.clear();
        work.broadPhase->cast(proxiesOf(world), toVec2(path.start), path.displacement,
                              {info.reach, info.reach}, 0xffffffffu, work.candidates, Among::All);
        for (const std::uint32_t shape : work.candidates) {
            const std::uint32_t other = world.shapes.info[shape].body;
            if (known[other] != kNone || !isDynamic(world, other) || work.slots[other] < 0) continue;
            if (!isFastBeside(pathOf(step, other), path, world.bodies.info[other])) continue;
            known[other] = 0;
            passed.push_back(other);
        }
    }
    work.fastBodies.insert(work.fastBodies.end(), passed.begin(), passed.end());
    if (!passed.empty()) std::sort(work.fastBodies.begin(), work.fastBodies.end());
}

}  // namespace

// Bodies that have moved fast are taken along their paths once more. Where one that flies freely hits
// something that never yields, or a bullet hits another that flies freely, both get the impulses of the
// impact at that moment and go on for the rest of the step. What something holds stops at that place with the
// velocity that it has there: the solver has to see the hit together with what holds it, which is in the next
// step.
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
    if (!moves || !step.runs(Effect::Contacts)) return;  // nothing can be stopped, or stop it
    const bool together = some([&](std::uint32_t body) { return layerOf(world, body) != kFastLayer; });
    if (together) updateBroadPhase(world, work);
    fillSwept(step, together);
    const int count = static_cast<int>(work.swept.size());
    const auto pieces = static_cast<std::size_t>(piecesOf(count, kGrain));
    if (work.sweptPast.size() < pieces) work.sweptPast.resize(pieces);
    if (work.countsOfPiece.size() < pieces) work.countsOfPiece.resize(pieces);
    std::fill(work.countsOfPiece.begin(), work.countsOfPiece.end(), DetectionCounts{});
    forPieces(step, count, kGrain, [&](int begin, int end, int piece) {
        const auto p = static_cast<std::size_t>(piece);
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            findNext(step, i, work.sweptPast[p], work.countsOfPiece[p]);
    });
    for (const DetectionCounts& counts : work.countsOfPiece) work.counts += counts;
    goThroughHits(step);
    placeHitBodies(step);
    beginHits(step);
}

}  // namespace plumb::physics
