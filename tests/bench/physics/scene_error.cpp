#include "tests/bench/physics/scene_error.hpp"

#include <algorithm>
#include <cmath>

#include "tests/bench/physics/overlap.hpp"

namespace plumb::scenes {

namespace {

constexpr double kLost = 10.0;  // m: gap of a joint from which a world does not recover

using Shape = SceneBuilder::Shape;

struct Entry {
    PlacedOutline outline;
    const Shape* shape = nullptr;
    bool dynamic = false;
};

/// Two bodies, the lower index first.
using Pair = std::pair<std::uint32_t, std::uint32_t>;

Pair pairOf(BodyHandle a, BodyHandle b) { return std::minmax({a.index, b.index}); }

std::vector<Pose> posesOf(const SceneBuilder& world) {
    std::vector<Pose> poses(world.bodies().size());
    for (std::uint32_t i = 0; i < poses.size(); ++i) {
        if (world.alive({i})) poses[i] = world.poseOf({i});
    }
    return poses;
}

std::vector<Pair> joinedPairs(const SceneBuilder& world) {
    std::vector<Pair> joined;
    for (const JointSetup& joint : world.joints()) joined.push_back(pairOf(joint.a, joint.b));
    std::sort(joined.begin(), joined.end());
    return joined;
}

bool mayCollide(const Material& a, const Material& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.layers & b.mask) != 0 && (b.layers & a.mask) != 0;
}

bool isExempt(const Entry& a, const Entry& b, std::span<const Pair> joined) {
    const BodyHandle bodyA = a.shape->body;
    const BodyHandle bodyB = b.shape->body;
    return bodyA.index == bodyB.index || (!a.dynamic && !b.dynamic) ||
           !mayCollide(a.shape->material, b.shape->material) ||
           std::binary_search(joined.begin(), joined.end(), pairOf(bodyA, bodyB));
}

std::vector<Entry> entriesOf(const SceneBuilder& world, std::span<const Pose> poses) {
    std::vector<Entry> entries;
    for (const Shape& shape : world.shapes()) {
        if (!world.alive(shape.body)) continue;
        entries.push_back(
            {place(shape.outline, poses[shape.body.index]), &shape, world.isDynamic(shape.body)});
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.outline.low.x < b.outline.low.x; });
    return entries;
}

void addOverlaps(const SceneBuilder& world, std::span<const Pose> poses, SceneError& error) {
    const std::vector<Entry> entries = entriesOf(world, poses);
    const std::vector<Pair> joined = joinedPairs(world);
    double sum = 0.0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const PlacedOutline& a = entries[i].outline;
        for (std::size_t j = i + 1; j < entries.size() && entries[j].outline.low.x <= a.high.x; ++j) {
            const PlacedOutline& b = entries[j].outline;
            if (a.low.y > b.high.y || b.low.y > a.high.y) continue;
            if (isExempt(entries[i], entries[j], joined)) continue;
            const double depth = overlapOf(a, b);
            if (depth <= kNoticed) continue;
            error.maxPenetration = std::max(error.maxPenetration, depth);
            sum += depth;
            ++error.overlaps;
        }
    }
    if (error.overlaps > 0) error.meanPenetration = sum / static_cast<double>(error.overlaps);
}

/// Returns the gap of a joint, m: by how much its anchor points deviate from what the joint allows.
double gapOf(const JointSetup& joint, std::span<const Pose> poses) {
    const Pose& poseA = poses[joint.a.index];
    const Point a = place(circle(0.0f, joint.anchorA), poseA).points[0];
    const Point b = place(circle(0.0f, joint.anchorB), poses[joint.b.index]).points[0];
    const double x = b.x - a.x, y = b.y - a.y, distance = std::sqrt(x * x + y * y);
    const auto axisX = static_cast<double>(joint.axis.x), axisY = static_cast<double>(joint.axis.y);
    switch (joint.kind) {
        case JointKind::Rod:
            return joint.sprung ? 0.0 : std::fabs(distance - static_cast<double>(joint.length));
        case JointKind::Slider:
        case JointKind::Wheel:
            return std::fabs((poseA.cos * axisX - poseA.sin * axisY) * y -
                             (poseA.sin * axisX + poseA.cos * axisY) * x);
        case JointKind::Hinge:
        case JointKind::Weld: break;
    }
    return distance;
}

void addJointErrors(const SceneBuilder& world, std::span<const Pose> poses, SceneError& error) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const JointSetup& joint : world.joints()) {
        if (!world.alive(joint.a) || !world.alive(joint.b)) continue;
        const double gap = gapOf(joint, poses);
        error.maxJointError = std::max(error.maxJointError, gap);
        sum += gap;
        ++count;
    }
    if (count > 0) error.meanJointError = sum / static_cast<double>(count);
}

bool areFinite(std::span<const Pose> poses) {
    return std::all_of(poses.begin(), poses.end(), [](const Pose& pose) {
        return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.cos) &&
               std::isfinite(pose.sin);
    });
}

}  // namespace

SceneError errorOf(const SceneBuilder& world) {
    SceneError error;
    const std::vector<Pose> poses = posesOf(world);
    error.finite = areFinite(poses);
    if (!error.finite) return error;
    addOverlaps(world, poses, error);
    addJointErrors(world, poses, error);
    return error;
}

bool isLost(const SceneBuilder& world) {
    const std::vector<Pose> poses = posesOf(world);
    if (!areFinite(poses)) return true;
    SceneError error;
    addJointErrors(world, poses, error);
    return error.maxJointError > kLost;
}

}  // namespace plumb::scenes
