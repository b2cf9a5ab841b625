#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "physics/bounds.hpp"
#include "physics/broadphase_update.hpp"
#include "physics/contacts.hpp"
#include "physics/effects/one_way.hpp"
#include "physics/joints.hpp"
#include "physics/narrowphase/sweep.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kGrain = 8;
/// Part of a slop that is left between what meets: as good as touching, and the direction is certain.
constexpr float kGap = 0.1f;

/// How much of an outline may not pass. What slides along a floor dips into it a little and is not to be
/// stopped for that: only what reaches deep could come out on the other side. Of outlines that are that deep
/// already, spinning or pressed, ever smaller cores are held back.
constexpr float kCores[] = {0.5f, 0.25f, 0.1f, 0.02f};

/// Who gets no further than this part of its way is wedged: it reaches into something already, and turns
/// under it faster than its contact can follow. Else it would stay there at full speed.
constexpr float kWedged = 0.02f;
/// Of its speeds.
constexpr float kKeptWhenWedged = 0.5f;

class Core {
public:
    Core(const Geometry& geometry, std::span<const Corner> pool, float part)
        : convex_{convexOf(geometry, pool)} {
        for (std::size_t i = 0; i < convex_.corners().size(); ++i) {
            const Corner& corner = convex_.corners()[i];
            corners_[i] = {convex_.centre + part * (corner.point - convex_.centre), corner.normal};
        }
        convex_.pool = corners_.data();
        convex_.radius *= part;
    }
    Core(const Core&) = delete;
    Core& operator=(const Core&) = delete;

    [[nodiscard]] const Convex& outline() const { return convex_; }

private:
    Convex convex_;
    std::array<Corner, kMaxCorners> corners_;
};

Rot turnOf(const Float4& shift) { return normalized(Rot{1.0f + shift.w, shift.z}); }

/// How a body has come through this step, but for the angle by which it turned: from where it is now and how
/// far it was shifted.
Sweep wayOf(const StepContext& step, std::uint32_t body) {
    const BodyPose& pose = step.world.bodies.pose[body];
    const Float4& shift = step.work.shift[static_cast<std::size_t>(step.work.slots[body])];
    Sweep sweep;
    sweep.way = {shift.x, shift.y};
    sweep.start = pose.centre + -sweep.way;
    sweep.rotation = normalized(inverse(turnOf(shift)) * pose.rotation);
    sweep.localCentre = pose.localCentre;
    return sweep;
}

void addTurn(const StepContext& step, std::uint32_t body, Sweep& sweep) {
    const auto slot = static_cast<std::size_t>(step.work.slots[body]);
    const float angle = angleOf(turnOf(step.work.shift[slot]));
    const float turns = (step.work.velocity[slot].z * step.dt - angle) / kTau;
    sweep.turn = angle + kTau * static_cast<float>(floorToInt(turns + 0.5f));
}

/// A shape and its way.
struct Mover {
    std::uint32_t shape;
    const Sweep& sweep;
};

/// True for a target that lets the mover through because of where it comes from.
bool opensFor(const World& world, const Mover& mover, const Mover& target) {
    const Geometry& outline = world.shapes.geometry[target.shape];
    if ((world.shapes.info[target.shape].flags & kOneWay) != 0) {
        const std::uint32_t body = world.shapes.info[mover.shape].body;
        if ((world.bodies.info[body].flags & kDropsThrough) != 0) return true;
        if (passesThrough(world, target.shape, mover.sweep.way)) return true;
    }
    if (outline.kind != ShapeKind::ChainSegment) return false;
    const BodyPose pose = target.sweep.at(0.0f), from = mover.sweep.at(0.0f);
    const Vec2 normal = rotate(pose.rotation, normalOfChain(outline));
    const Vec2 start = rotate(pose.rotation, outline.a - pose.localCentre);
    const Convex own = convexOf(world.shapes.geometry[mover.shape], world.shapes.corners);
    const Vec2 centre = rotate(from.rotation, own.centre - from.localCentre) + (from.centre - pose.centre);
    return dot(normal, centre - start) < 0.0f;
}

bool mayMeet(const World& world, std::uint32_t a, std::uint32_t b) {
    const Shapes& shapes = world.shapes;
    if (((shapes.info[a].flags | shapes.info[b].flags) & kTrigger) != 0) return false;
    if (!meet(shapes.filter[a], shapes.filter[b]) || !comesTo(world, a, b)) return false;
    const std::uint32_t bodyA = shapes.info[a].body, bodyB = shapes.info[b].body;
    return world.bodies.info[bodyA].firstJoint == kNone || !keptApart(world, bodyA, bodyB);
}

/// The part of the way at which the mover has to stop, or `latest`. Outlines that touched from the start are
/// held by their contact, until even a core would pass.
float stopAt(const World& world, const Mover& mover, const Mover& target, float latest) {
    if (!mayMeet(world, mover.shape, target.shape) || opensFor(world, mover, target)) return latest;
    const Geometry& geometry = world.shapes.geometry[mover.shape];
    const Convex theirs = convexOf(world.shapes.geometry[target.shape], world.shapes.corners);
    const SweptOutline other{theirs, target.sweep};
    const auto impactOf = [&](const Convex& outline, float gap) {
        return firstImpact(other, {outline, mover.sweep}, gap, latest);
    };
    for (const float part : kCores) {
        const auto deep = impactOf(Core{geometry, world.shapes.corners, part}.outline(), 0.0f);
        if (!deep) return latest;
        if (deep->part == 0.0f) continue;
        latest = deep->part;
        const auto touch = impactOf(convexOf(geometry, world.shapes.corners), kGap * world.settings.slop);
        return touch && touch->part > 0.0f ? touch->part : latest;
    }
    return latest;
}

/// Where the shapes of the body stop at shapes that come into question.
float stopOfBody(const World& world, const Sweep& sweep, std::uint32_t body, const Mover& target,
                 float latest, DetectionCounts& counts) {
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next) {
        ++counts.swept;
        latest = stopAt(world, {s, sweep}, target, latest);
    }
    return latest;
}

/// m: half the side of a square at the centre of mass that contains the body, whatever its angle, and the gap
/// that it keeps.
float reachOf(const StepContext& step, const Sweep& sweep, std::uint32_t body) {
    const Vec2 from = toVec2(sweep.start);
    const float rounding = 5.0e-7f * std::max(std::fabs(from.x), std::fabs(from.y));
    return step.world.bodies.info[body].reach + rounding + step.world.settings.speculativeDistance;
}

/// Shapes near the way of a body, in the order of their numbers: where it stops depends on which is tested
/// first, and a broad phase gives them in an order of its own.
void findOnWay(const StepContext& step, const Sweep& sweep, std::uint32_t body, Among among,
               std::vector<std::uint32_t>& found) {
    const Vec2 from = toVec2(sweep.start);
    const float reach = reachOf(step, sweep, body);
    found.clear();
    step.work.broadPhase->cast(proxiesOf(step.world), from, sweep.way, {reach, reach}, 0xffffffffu, found,
                               among);
    std::sort(found.begin(), found.end());
}

/// Lets a sweep end at the first shape that never yields.
void stopAtFixed(const StepContext& step, std::uint32_t body, Sweep& sweep, std::vector<std::uint32_t>& found,
                 DetectionCounts& counts) {
    const World& world = step.world;
    findOnWay(step, sweep, body, world.manifest.runs(Effect::Kinematics) ? Among::All : Among::Static, found);
    if (found.empty()) return;
    addTurn(step, body, sweep);
    float latest = 1.0f;
    for (const std::uint32_t shape : found) {
        const ProxyMotion motion = world.shapes.motion[shape];
        if (motion != ProxyMotion::Static && motion != ProxyMotion::Kinematic) continue;
        const Sweep stays = resting(world.bodies.pose[world.shapes.info[shape].body]);
        latest = stopOfBody(world, sweep, body, {shape, stays}, latest, counts);
    }
    sweep.end = latest;
}

/// Takes from a body what it gained by falling over the part of its way that it is set back by. Else it would
/// be faster than its height explains: small balls would bounce higher and higher.
/// @param part  of the way of this step
void takeBackGain(StepContext& step, std::uint32_t body, Vec2 way, float part) {
    const Workspace& work = step.work;
    const auto slot = static_cast<std::size_t>(work.slots[body]);
    const Float4& flight = work.flight[slot];
    const bool tied = step.world.bodies.info[body].firstJoint != kNone;
    const bool held = tied || (flight.x == 0.0f && flight.y == 0.0f);
    const Vec2 pull{work.drive[slot].x, work.drive[slot].y};
    Vec2& velocity = step.world.bodies.motion[body].velocity;
    if (held) {
        // What else pulls at it is not known: as much energy goes as the way back gives.
        const float gain = 2.0f * part * dot(pull, way), before = lengthSquared(velocity);
        if (gain > 0.0f) velocity *= std::sqrt(std::max(before - gain, 0.0f) / std::max(before, gain));
    } else if (const bool dragged = !work.keep.empty() && work.keep[slot].x != 1.0f; !dragged) {
        velocity -= (part * step.dt) * pull;
    }
}

/// Takes a body back along its way, from a part of it to the end of the sweep.
void setBack(StepContext& step, std::uint32_t body, const Sweep& sweep, float from) {
    World& world = step.world;
    takeBackGain(step, body, sweep.way, from - sweep.end);
    if (sweep.end < kWedged) {
        world.bodies.motion[body].velocity *= kKeptWhenWedged;
        world.bodies.motion[body].angularVelocity *= kKeptWhenWedged;
    }
    world.bodies.pose[body] = sweep.at(sweep.end);
    Shapes& shapes = world.shapes;
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = shapes.info[s].next) {
        shapes.bounds[s] = grown(tightBounds(world, s), shapes.info[s].margin);
        noteChanged(world, s);
        noteMoved(world, s);
    }
}

bool isBullet(const World& world, std::uint32_t body) {
    return (world.bodies.info[body].flags & kBullet) != 0;
}

/// The same for fast bodies: their places in Workspace::fastBodies.
void findSweptOnWay(const StepContext& step, const Sweep& sweep, std::uint32_t body,
                    std::vector<std::uint32_t>& found) {
    const float reach = reachOf(step, sweep, body);
    found.clear();
    step.work.sweptBounds.cast(toVec2(sweep.start), sweep.way * sweep.end, {reach, reach}, 1u, found);
    std::sort(found.begin(), found.end());
}

/// Bodies that have moved far themselves are met on their way, both at one time; all others where they are.
/// @param places  in Workspace::fastBodies, by body
void sweepBullet(StepContext& step, std::uint32_t place, const std::vector<std::uint32_t>& places) {
    World& world = step.world;
    Workspace& work = step.work;
    const std::uint32_t bullet = work.fastBodies[place];
    Sweep& sweep = work.sweeps[place];
    float latest = sweep.end;
    std::uint32_t met = kNone;
    findOnWay(step, sweep, bullet, Among::All, work.candidates);
    for (const std::uint32_t shape : work.candidates) {
        const std::uint32_t body = world.shapes.info[shape].body;
        const ProxyMotion motion = world.shapes.motion[shape];
        const bool fixed = motion == ProxyMotion::Static || motion == ProxyMotion::Kinematic;
        if (fixed || places[body] != kNone) continue;
        const Sweep stays = resting(world.bodies.pose[body]);
        latest = stopOfBody(world, sweep, bullet, {shape, stays}, latest, work.counts);
    }
    findSweptOnWay(step, sweep, bullet, work.candidates);
    for (const std::uint32_t other : work.candidates) {
        if (other == place) continue;
        const std::uint32_t body = work.fastBodies[other];
        for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone;
             s = world.shapes.info[s].next) {
            const float stop = stopOfBody(world, sweep, bullet, {s, work.sweeps[other]}, latest, work.counts);
            if (stop < latest) latest = stop, met = other;
        }
    }
    if (latest == sweep.end) return;
    const float before = std::exchange(sweep.end, latest);
    setBack(step, bullet, sweep, before);
    if (met == kNone || work.sweeps[met].end <= latest) return;
    const float otherBefore = std::exchange(work.sweeps[met].end, latest);
    setBack(step, work.fastBodies[met], work.sweeps[met], otherBefore);
}

/// Bounds of whole sweeps, so that each bullet finds the fast bodies that it may meet without a look at the
/// others.
void fillSweptBounds(StepContext& step) {
    Workspace& work = step.work;
    work.sweptBounds.clear();
    for (std::size_t i = 0; i < work.sweeps.size(); ++i) {
        const Sweep& sweep = work.sweeps[i];
        const float reach = reachOf(step, sweep, work.fastBodies[i]);
        const Vec2 from = toVec2(sweep.start), to = from + sweep.way * sweep.end, half{reach, reach};
        work.sweptBounds.add({min(from, to) - half, max(from, to) + half}, 1u);
    }
    work.sweptBounds.settle();
}

void sweepBullets(StepContext& step) {
    Workspace& work = step.work;
    fillSweptBounds(step);
    std::vector<std::uint32_t>& places = work.bodyScratch;
    places.assign(step.world.bodies.size(), kNone);
    for (std::uint32_t i = 0; i < work.fastBodies.size(); ++i) places[work.fastBodies[i]] = i;
    for (std::uint32_t i = 0; i < work.fastBodies.size(); ++i) {
        if (isBullet(step.world, work.fastBodies[i])) sweepBullet(step, i, places);
    }
}

}  // namespace

// Sweeps go from where a body was to where it is; those that meet something are set back to just before. They
// keep the velocity that they had there: the next step finds the contact, and stops or bounces them.
void sweepFastBodies(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    const auto count = work.fastBodies.size();
    if (count == 0 || !step.runs(Effect::Contacts)) return;  // nothing can stop them
    const bool bullets = std::any_of(work.fastBodies.begin(), work.fastBodies.end(),
                                     [&](std::uint32_t body) { return isBullet(world, body); });
    if (bullets || step.runs(Effect::Kinematics)) updateBroadPhase(world, work);
    work.sweeps.resize(count);
    const auto pieces = static_cast<std::size_t>(piecesOf(static_cast<int>(count), kGrain));
    if (work.sweptPast.size() < pieces) work.sweptPast.resize(pieces);
    if (work.countsOfPiece.size() < pieces) work.countsOfPiece.resize(pieces);
    std::fill(work.countsOfPiece.begin(), work.countsOfPiece.end(), DetectionCounts{});
    forPieces(step, static_cast<int>(count), kGrain, [&](int begin, int end, int piece) {
        const auto p = static_cast<std::size_t>(piece);
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            work.sweeps[i] = wayOf(step, work.fastBodies[i]);
            if (bullets) addTurn(step, work.fastBodies[i], work.sweeps[i]);
            stopAtFixed(step, work.fastBodies[i], work.sweeps[i], work.sweptPast[p], work.countsOfPiece[p]);
        }
    });
    for (const DetectionCounts& counts : work.countsOfPiece) work.counts += counts;
    for (std::size_t i = 0; i < count; ++i) {
        if (work.sweeps[i].end < 1.0f) setBack(step, work.fastBodies[i], work.sweeps[i], 1.0f);
    }
    if (bullets) sweepBullets(step);
}

}  // namespace plumb::physics
