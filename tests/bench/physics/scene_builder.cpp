#include "tests/bench/physics/scene_builder.hpp"

#include <algorithm>

namespace plumb::scenes {

namespace {

Outline outlineOf(OutlineKind kind, std::span<const Vec2> points, float radius) {
    Outline outline{.kind = kind, .count = static_cast<std::uint8_t>(points.size()), .radius = radius};
    std::copy(points.begin(), points.end(), outline.points.begin());
    return outline;
}

/// Returns twice the signed area of the triangle a, b, c; positive if it is counterclockwise.
float turnOf(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// Returns the convex hull in counterclockwise order, which all engines require.
/// Source: A. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
std::vector<Vec2> hullOf(std::span<const Vec2> points) {
    std::vector<Vec2> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(),
              [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Vec2> hull;
    const auto sweep = [&hull](auto first, auto last) {
        const std::size_t start = hull.size();
        for (auto point = first; point != last; ++point) {
            while (hull.size() >= start + 2 && turnOf(hull[hull.size() - 2], hull.back(), *point) <= 0.0f)
                hull.pop_back();
            hull.push_back(*point);
        }
        hull.pop_back();
    };
    sweep(sorted.begin(), sorted.end());
    sweep(sorted.rbegin(), sorted.rend());
    return hull;
}

}  // namespace

Outline circle(float radius, Vec2 centre) { return outlineOf(OutlineKind::Circle, {{centre}}, radius); }

Outline capsule(Vec2 start, Vec2 end, float radius) {
    return outlineOf(OutlineKind::Capsule, {{start, end}}, radius);
}

Outline box(Vec2 half, Vec2 centre, float radius) {
    const Vec2 corners[] = {centre + Vec2{-half.x, -half.y}, centre + Vec2{half.x, -half.y}, centre + half,
                            centre + Vec2{-half.x, half.y}};
    Outline outline = outlineOf(OutlineKind::Box, corners, radius);
    outline.centre = centre;
    outline.half = half;
    return outline;
}

Outline polygon(std::span<const Vec2> points, float radius) {
    return outlineOf(OutlineKind::Polygon, hullOf(points), radius);
}

Outline segment(Vec2 start, Vec2 end) { return outlineOf(OutlineKind::Segment, {{start, end}}, 0.0f); }

BodyHandle SceneBuilder::createBody(const BodySetup& setup) {
    const BodyHandle body{static_cast<std::uint32_t>(bodies_.size())};
    bodies_.push_back({setup.motion, true});
    makeBody(body, setup);
    return body;
}

void SceneBuilder::addShape(BodyHandle body, const Outline& outline, const Material& material) {
    shapes_.push_back({body, outline, material});
    makeShape(body, outline, material);
}

void SceneBuilder::addLoop(BodyHandle body, std::span<const Vec2> points, const Material& material) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 ends[] = {points[i], points[(i + 1) % points.size()]};
        shapes_.push_back({body, outlineOf(OutlineKind::ChainSegment, ends, 0.0f), material});
    }
    makeLoop(body, points, material);
}

void SceneBuilder::addJoint(const JointSetup& joint) {
    joints_.push_back(joint);
    makeJoint(joint);
}

void SceneBuilder::destroy(BodyHandle body) {
    bodies_[body.index].alive = false;
    dropBody(body);
}

}  // namespace plumb::scenes
