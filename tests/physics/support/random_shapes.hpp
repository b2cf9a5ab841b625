#pragma once

#include <vector>

#include "core/random.hpp"
#include "physics/shapes/hull.hpp"
#include "physics/shapes/shape_types.hpp"

// Random outlines for property tests, each about as large as the parameter `size`.

namespace plumb::physics::test {

inline constexpr std::uint64_t kSeeds = 200;  // number of random cases that a test tries

/// A geometry together with its corners, which are empty except for polygons.
struct Outline {
    Geometry geometry;
    std::vector<Corner> corners;
};

inline Vec2 randomPoint(Random& random, float size) {
    return {random.between(-size, size), random.between(-size, size)};
}
inline Rot randomRotation(Random& random) { return rotFromAngle(random.between(-kPi, kPi)); }
inline Frame randomFrame(Random& random, float size) {
    return {randomPoint(random, size), randomRotation(random)};
}

inline Outline outlineOf(const Hull& hull, float radius = 0.0f) {
    return {polygon(hull, 0, radius), {hull.corners.begin(), hull.corners.end()}};
}

/// Creates a random convex polygon of up to 12 corners.
inline Outline randomPolygon(Random& random, float size, float radius = 0.0f) {
    for (;;) {
        std::vector<Vec2> points;
        const std::uint32_t count = 3 + random.below(10);
        for (std::uint32_t i = 0; i < count; ++i) points.push_back(randomPoint(random, size));
        if (auto hull = makeHull(points)) return outlineOf(*hull, radius);
    }
}

inline Outline regularPolygon(int count, float reach, float radius = 0.0f) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const SinCos at = sinCos(kTau * static_cast<float>(i) / static_cast<float>(count));
        points.push_back({reach * at.cos, reach * at.sin});
    }
    return outlineOf(*makeHull(points), radius);
}

inline Outline randomOutline(Random& random, ShapeKind kind, float size) {
    const float radius = random.below(2) == 0 ? 0.0f : random.between(0.01f, 0.5f) * size;
    switch (kind) {
        case ShapeKind::Circle:
            return {circle(random.between(0.1f, 1.0f) * size, randomPoint(random, size)), {}};
        case ShapeKind::Capsule:
            return {capsule(randomPoint(random, size), randomPoint(random, size),
                            random.between(0.05f, 0.5f) * size),
                    {}};
        case ShapeKind::Box:
            return {box({random.between(0.05f, 1.0f) * size, random.between(0.05f, 1.0f) * size},
                        randomPoint(random, size), randomRotation(random), radius),
                    {}};
        case ShapeKind::Polygon: return randomPolygon(random, size, radius);
        case ShapeKind::Segment:
        case ShapeKind::ChainSegment:
        case ShapeKind::Count: break;
    }
    return {segment(randomPoint(random, size), randomPoint(random, size)), {}};
}

inline constexpr ShapeKind kSolidKinds[] = {ShapeKind::Circle, ShapeKind::Capsule, ShapeKind::Box,
                                            ShapeKind::Polygon};
inline constexpr ShapeKind kConvexKinds[] = {ShapeKind::Circle, ShapeKind::Capsule, ShapeKind::Box,
                                             ShapeKind::Polygon, ShapeKind::Segment};

}  // namespace plumb::physics::test
