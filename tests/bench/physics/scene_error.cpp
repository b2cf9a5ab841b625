#include "tests/bench/physics/scene_error.hpp"

#include <algorithm>
#include <cmath>

#include "tests/bench/physics/overlap.hpp"

namespace plumb::scenes {

namespace {

constexpr double kLost = 10.0;  // m

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
    for (const Hinge& hinge : world.hinges()) joined.push_back(pairOf(hinge.a, hinge.b));
    std::sort(joined.begin(), joined.end());
    return joined;
}

bool meet(const Material& a, const Material& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.layers & b.mask) != 0 && (b.layers & a.mask) != 0;
}

bool isExempt(const Entry& a, const Entry& b, std::span<const Pair> joined) {
    const BodyHandle bodyA = a.shape->body;
    const BodyHandle bodyB = b.shape->body;
    return bodyA.index == bodyB.index || (!a.dynamic && !b.dynamic) ||
           !meet(a.shape->material, b.shape->material) ||
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

void addJointErrors(const SceneBuilder& world, std::span<const Pose> poses, SceneError& error) {
    const auto anchorOf = [poses](BodyHandle body, Vec2 anchor) {
        return place(circle(0.0f, anchor), poses[body.index]).points[0];
    };
    double sum = 0.0;
    std::size_t count = 0;
    for (const Hinge& hinge : world.hinges()) {
        if (!world.alive(hinge.a) || !world.alive(hinge.b)) continue;
        const Point a = anchorOf(hinge.a, hinge.anchorA);
        const Point b = anchorOf(hinge.b, hinge.anchorB);
        const double gap = std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
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
