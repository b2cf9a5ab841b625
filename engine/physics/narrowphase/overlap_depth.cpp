#include "physics/narrowphase/minkowski.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// The Minkowski difference has at most as many vertices as both outlines together.
constexpr int kMaxWays = 2 * kMaxCorners + 4;

/// A polygon inside the Minkowski difference that is expanded towards its boundary. Its vertices are in the
/// order in which normals rotate.
struct Polytope {
    Way displacements[kMaxWays];
    int count = 0;
    float size = 0.0f;  ///< m: maximum coordinate of its vertices

    bool contains(const Way& displacement) const {
        for (int i = 0; i < count; ++i) {
            if (displacements[i] == displacement) return true;
        }
        return false;
    }
    void insert(int place, const Way& displacement) {
        for (int i = count; i > place; --i) displacements[i] = displacements[i - 1];
        displacements[place] = displacement;
        ++count;
        size = std::max(
            size, std::max(std::fabs(displacement.displacement.x), std::fabs(displacement.displacement.y)));
    }
};

/// The extreme vertices along both axes: a polygon, or two points if the difference is a segment. It need not
/// contain the origin; if it does not, the origin is outside of the edge that is expanded first.
Polytope startFrom(const Displacements& set) {
    Polytope polytope;
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        const Way displacement = set.farthestAlong(direction);
        bool known = false;
        for (int i = 0; i < polytope.count; ++i) {
            known = known || distance(polytope.displacements[i].displacement, displacement.displacement) <=
                                 kSimplexPrecision * polytope.size;
        }
        if (!known) polytope.insert(polytope.count, displacement);
    }
    return polytope;
}

/// The edge nearest to the origin.
struct NearestSide {
    int index = 0;
    Vec2 normal = kAnyNormal;
    float distance = 1.0e30f;
};

NearestSide nearestSide(const Polytope& polytope) {
    NearestSide nearest;
    for (int i = 0; i < polytope.count; ++i) {
        const Vec2 start = polytope.displacements[i].displacement;
        const Vec2 side = polytope.displacements[i + 1 < polytope.count ? i + 1 : 0].displacement - start;
        const Vec2 normal = normalized(Vec2{side.y, -side.x});
        const float distance = dot(normal, start);
        if (normal == Vec2{} || !(distance < nearest.distance)) continue;
        nearest = {i, normal, distance};
    }
    return nearest;
}

}  // namespace

DisplacementBetween deepestOverlap(const Displacements& displacements) {
    Polytope polytope = startFrom(displacements);
    DisplacementBetween result{
        polytope.displacements[0], polytope.displacements[0], 0.0f, kAnyNormal, 0.0f, 0};
    if (polytope.count < 2) return result;  // two discs with the same centre
    NearestSide side = nearestSide(polytope);
    while (polytope.count < kMaxWays) {
        ++result.iterations;
        const Way displacement = displacements.farthestAlong(side.normal);
        const float out = dot(displacement.displacement, side.normal) - side.distance;
        if (!(out > kSimplexPrecision * polytope.size) || polytope.contains(displacement)) break;
        polytope.insert(side.index + 1, displacement);
        side = nearestSide(polytope);
    }
    result.first = polytope.displacements[side.index];
    result.second = polytope.displacements[side.index + 1 < polytope.count ? side.index + 1 : 0];
    // The difference is B - A, and the origin lies this deep inside it, so B has to move in the opposite
    // direction to separate.
    result.normal = -side.normal;
    result.distance = -side.distance;
    const Vec2 edge = result.second.displacement - result.first.displacement;
    const float square = lengthSquared(edge);
    result.part = square > 0.0f ? -dot(result.first.displacement, edge) / square : 0.0f;
    result.part = result.part < 0.0f ? 0.0f : result.part > 1.0f ? 1.0f : result.part;
    return result;
}

}  // namespace plumb::physics
