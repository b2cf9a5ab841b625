#include "physics/continuous/swept_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/broadphase/overlap.hpp"
#include "physics/edits.hpp"
#include "physics/ranges.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

Rot turnOf(const Float4& deltaPosition) { return normalized(Rot{1.0f + deltaPosition.w, deltaPosition.z}); }

/// Returns half the side (m) of a square that contains the body at any angle, with a margin.
float reachOf(const StepContext& step, const SweptBody& swept) {
    const float rounding = kRounding * largestOf(toVec2(swept.sweep.start));
    return step.world.bodies.info[swept.body].reach + rounding + step.world.settings.speculativeDistance;
}
Vec2 beginOf(const Sweep& sweep) { return toVec2(sweep.start + sweep.displacement * sweep.begin); }
Vec2 displacementLeft(const Sweep& sweep) { return sweep.displacement * std::max(1.0f - sweep.begin, 0.0f); }

/// Appends the indices of swept bodies on these layers whose paths may cross the path of a box.
void findPaths(const Workspace& work, Vec2 from, Vec2 displacement, Vec2 half, std::uint32_t layers,
               std::vector<std::uint32_t>& found) {
    const BoxProxies& paths = work.sweptProxies;
    if (!areFewPaths(work)) return paths.search->cast(from, displacement, half, layers, found, Among::All);
    const LineSweep sweep = lineSweep(from, displacement, half);
    for (std::uint32_t i = 0; i < paths.bounds.size(); ++i) {
        if (touch(paths.bounds[i], sweep.bounds) && (paths.filters[i].layers & layers) != 0 &&
            mayCollide(sweep, paths.bounds[i]))
            found.push_back(i);
    }
}

/// Returns an upper bound (m) of the displacement of any point in the step. Infinite for a body deflected by
/// a hit, as its bounds do not contain its new path.
float longestPath(const World& world, const SweptBody& swept) {
    if (swept.hits > 0) return std::numeric_limits<float>::max();
    return length(swept.sweep.displacement) +
           std::fabs(swept.sweep.angle) * world.bodies.info[swept.body].reach;
}

}  // namespace

Sweep pathOf(const StepContext& step, std::uint32_t body) {
    const BodyPose& pose = step.world.bodies.pose[body];
    const auto slot = static_cast<std::size_t>(step.work.slots[body]);
    const Float4& deltaPosition = step.work.deltaPosition[slot];
    const Vec2 displacement{deltaPosition.x, deltaPosition.y};
    Sweep sweep{pose.centre + -displacement, displacement, pose.rotation, 0.0f, pose.localCentre};
    if (deltaPosition.z == 0.0f && step.work.velocity[slot].z == 0.0f) return sweep;
    const float angle = angleOf(turnOf(deltaPosition));
    const float turns = (step.work.velocity[slot].z * step.dt - angle) / kTau;
    sweep.angle = angle + kTau * static_cast<float>(floorToInt(turns + 0.5f));
    sweep.rotation = normalized(inverse(turnOf(deltaPosition)) * pose.rotation);
    return sweep;
}

Sweep currentPathOf(const StepContext& step, std::uint32_t body) {
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
    // The path has the mean velocity: the acceleration follows from its difference to the final velocity.
    const Vec2 velocity = step.world.bodies.motion[body].velocity;
    swept.pull = (2.0f / step.dt) * (velocity - (1.0f / step.dt) * swept.sweep.displacement);
    return swept;
}

bool isFastBeside(const Sweep& own, const Sweep& path, const BodyInfo& info) {
    if (path.angle == 0.0f) return isFast(own.displacement - path.displacement, own.angle, info);
    const Vec2 arm = own.start - path.start;
    const Vec2 carried = path.displacement + rotate(rotFromAngle(path.angle), arm) - arm;
    return std::fabs(path.angle) > kWide || isFast(own.displacement - carried, own.angle - path.angle, info);
}

void limitMotion(World& world, std::uint32_t body) {
    BodyMotion& motion = world.bodies.motion[body];
    const float maximum = world.settings.maxSpeed, reach = world.bodies.info[body].reach;
    const float square = lengthSquared(motion.velocity), spin = std::fabs(motion.angularVelocity);
    if (square > maximum * maximum) motion.velocity *= maximum / std::sqrt(square);
    if (spin * reach > maximum || spin > kFastest)
        motion.angularVelocity = std::copysign(std::min(maximum / reach, kFastest), motion.angularVelocity);
}

AABB pathBounds(const StepContext& step, const SweptBody& swept) {
    const float reach = reachOf(step, swept);
    const Vec2 from = beginOf(swept.sweep), to = from + displacementLeft(swept.sweep), half{reach, reach};
    return {min(from, to) - half, max(from, to) + half};
}

void findNextHit(const StepContext& step, std::size_t place, std::vector<std::uint32_t>& found,
                 DetectionCounts& counts) {
    const World& world = step.world;
    const Workspace& work = step.work;
    SweptBody& swept = step.work.swept[place];
    const Sweep& sweep = swept.sweep;
    swept.next = {};
    if (!isDynamic(world, swept.body) || swept.hits > kMaxImpacts || sweep.begin >= 1.0f) return;
    const auto meetAll = [&](std::uint32_t shape) {
        if (shape == swept.passed) return;
        const Sweep path = currentPathOf(step, world.shapes.info[shape].body);
        if (swept.hits == 0 && !isFastBeside(sweep, path, world.bodies.info[swept.body])) return;
        forShapesOf(world, swept.body, [&](std::uint32_t s) {
            ++counts.swept;
            meetOnPath(world, {s, sweep, !swept.isHeld}, {shape, path}, swept.next);
        });
    };
    const float reach = reachOf(step, swept);
    const Vec2 from = beginOf(sweep), displacement = displacementLeft(sweep), half{reach, reach};
    const bool all = isBullet(world, swept.body);
    found.clear();
    work.broadPhase->cast(from, displacement, half, 0xffffffffu, found,
                          all || work.kinematicsAtRest ? Among::All : Among::Static);
    std::sort(found.begin(), found.end());
    for (const std::uint32_t shape : found) {
        const std::uint32_t body = world.shapes.info[shape].body;
        if (work.bodyScratch[body] == kNone && (all || !isDynamic(world, body))) meetAll(shape);
    }
    if (work.sweptProxies.bounds.empty()) return;
    // Bullets hit all bodies. Bodies deflected by a hit search for bullets, which tested only the old path.
    const std::uint32_t layers =
        kKinematicLayer | (all || swept.hits > 0 ? kBulletLayer : 0) | (all ? kFastLayer : 0);
    found.clear();
    findPaths(work, from, displacement, half, layers, found);
    std::sort(found.begin(), found.end());
    for (const std::uint32_t other : found) {
        if (other == place) continue;
        const SweptBody& second = work.swept[other];
        const AABB near = grown(pathBounds(step, swept), longestPath(world, second));
        forShapesOf(world, second.body, [&](std::uint32_t s) {
            if (intersects(world.shapes.bounds[s], near)) meetAll(s);
        });
    }
    if (swept.next.other != kNone)
        swept.next.otherHits = hitsOf(work, world.shapes.info[swept.next.other].body);
}

}  // namespace plumb::physics
