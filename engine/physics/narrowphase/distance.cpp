#include "physics/narrowphase/distance.hpp"

#include <algorithm>

#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// A vertex of the Minkowski difference B - A, and the corners of A and B whose difference it is.
struct Way {
    Vec2 displacement;
    Vec2 a, b;
    std::uint8_t indexA = 0;
    std::uint8_t indexB = 0;

    friend bool operator==(const Way& left, const Way& right) {
        return left.indexA == right.indexA && left.indexB == right.indexB;
    }
};

/// The Minkowski difference B - A in A's frame. The outlines overlap if it contains the origin.
struct Displacements {
    const Convex& a;
    const Convex& b;
    const Frame& bInA;

    [[nodiscard]] Way at(int indexA, int indexB) const {
        const Vec2 inA = a.corners()[static_cast<std::size_t>(indexA)].point;
        const Vec2 inB = apply(bInA, b.corners()[static_cast<std::size_t>(indexB)].point);
        return {inB - inA, inA, inB, static_cast<std::uint8_t>(indexA), static_cast<std::uint8_t>(indexB)};
    }
    [[nodiscard]] Way farthestAlong(Vec2 direction) const {
        return at(farthest(a.corners(), -direction),
                  farthest(b.corners(), unrotate(bInA.rotation, direction)));
    }
};

/// Nearest point of the Minkowski difference to the origin: `part` is 0 at the first vertex, 1 at the second.
struct DisplacementBetween {
    Way first, second;
    float part = 0.0f;
    Vec2 normal = kAnyNormal;  ///< unit length, from A to B
    float distance = 0.0f;     ///< m along the normal; negative: overlap
    int iterations = 0;
};

/// Limit against endless loops due to rounding; larger than necessary for any outlines with kMaxCorners.
constexpr int kMaxIterations = 2 * kMaxCorners;

template <int kCapacity>
struct Points {
    Way displacements[kCapacity];
    int count = 0;

    [[nodiscard]] bool has(const Way& displacement) const {
        return std::find(displacements, displacements + count, displacement) != displacements + count;
    }
};

struct Simplex : Points<3> {
    float part = 0.0f;  ///< with two points: position of the nearest point, 0 to 1 between them

    void keep(int i) {
        displacements[0] = displacements[i];
        count = 1;
    }
};

/// Reduces a segment to the end nearest to the origin, or computes `part` between 0 and 1.
void reduceTwo(Simplex& simplex) {
    const Vec2 first = simplex.displacements[0].displacement;
    const Vec2 edge = simplex.displacements[1].displacement - first;
    const float along = -dot(first, edge);
    const float square = lengthSquared(edge);
    if (!(along > 0.0f)) return simplex.keep(0);
    if (!(along < square)) return simplex.keep(1);
    simplex.part = along / square;
}

/// Reduces a triangle to the corner or side nearest to the origin; keeps all three if the origin is inside.
void reduceThree(Simplex& simplex) {
    Simplex best;
    float minimum = 1.0e30f;
    const Vec2 a = simplex.displacements[0].displacement;
    const Vec2 b = simplex.displacements[1].displacement;
    const Vec2 c = simplex.displacements[2].displacement;
    const float area = cross(b - a, c - a);
    const float sign = area < 0.0f ? -1.0f : 1.0f;
    bool inside = area != 0.0f;
    for (int i = 0; i < 3; ++i) {
        Simplex side{{{simplex.displacements[i], simplex.displacements[(i + 1) % 3], {}}, 2}, 0.0f};
        const Vec2 &from = side.displacements[0].displacement, &to = side.displacements[1].displacement;
        inside = inside && sign * cross(from, to) > 0.0f;
        reduceTwo(side);
        const Vec2 place = side.count == 1 ? from : lerp(from, to, side.part);
        const float square = lengthSquared(place);
        if (square < minimum) {
            minimum = square;
            best = side;
        }
    }
    if (!inside) simplex = best;
}

Simplex startFrom(const Displacements& displacements, const SimplexCache* cache) {
    Simplex simplex;
    if (cache != nullptr && cache->count <= 3) {
        for (int i = 0; i < cache->count; ++i) {
            if (cache->a[i] >= displacements.a.count || cache->b[i] >= displacements.b.count) continue;
            const Way displacement = displacements.at(cache->a[i], cache->b[i]);
            if (!simplex.has(displacement)) simplex.displacements[simplex.count++] = displacement;
        }
    }
    if (simplex.count == 0) {
        const Vec2 towards = displacements.a.centre - apply(displacements.bInA, displacements.b.centre);
        simplex.displacements[simplex.count++] = displacements.farthestAlong(towards);
    }
    return simplex;
}

float sizeOf(const Simplex& simplex) {
    float size = 0.0f;
    for (int i = 0; i < simplex.count; ++i)
        size = std::max({size, largestOf(simplex.displacements[i].a), largestOf(simplex.displacements[i].b)});
    return size;
}

/// Computes the distance of the simplex from the origin. For a segment it uses the perpendicular, which is
/// accurate when the outlines almost touch.
DisplacementBetween nearestOf(const Simplex& simplex) {
    DisplacementBetween nearest{simplex.displacements[0], simplex.displacements[0]};
    if (simplex.count == 1) {
        nearest.distance = length(simplex.displacements[0].displacement);
        if (nearest.distance > 0.0f) nearest.normal = nearest.first.displacement / nearest.distance;
        return nearest;
    }
    nearest.second = simplex.displacements[1];
    nearest.part = simplex.part;
    nearest.normal = normalized(perpendicular(nearest.second.displacement - nearest.first.displacement));
    nearest.distance = dot(nearest.normal, nearest.first.displacement);
    if (nearest.distance < 0.0f) {
        nearest.normal = -nearest.normal;
        nearest.distance = -nearest.distance;
    }
    return nearest;
}

/// GJK. Returns the shortest connection of the cores; at an overlap three points, or a distance near 0.
DisplacementBetween nearestWay(const Displacements& displacements, Simplex& simplex) {
    DisplacementBetween nearest;
    for (int iteration = 1;; ++iteration) {
        if (simplex.count == 2) reduceTwo(simplex);
        if (simplex.count == 3) reduceThree(simplex);
        if (simplex.count < 3) nearest = nearestOf(simplex);
        nearest.iterations = iteration;
        if (simplex.count == 3 || iteration == kMaxIterations ||
            nearest.distance <= kSimplexPrecision * sizeOf(simplex))
            return nearest;
        const Way displacement = displacements.farthestAlong(-nearest.normal);
        const float nearer = nearest.distance - dot(displacement.displacement, nearest.normal);
        if (nearer <= kSimplexPrecision * nearest.distance || simplex.has(displacement)) return nearest;
        simplex.displacements[simplex.count++] = displacement;
    }
}

/// Capacity of a Polytope: the Minkowski difference has at most the vertices of both outlines together.
constexpr int kMaxWays = 2 * kMaxCorners + 4;

/// A polygon inside the Minkowski difference that EPA expands to its boundary. Orientation: from x to y.
struct Polytope : Points<kMaxWays> {
    float size = 0.0f;  ///< m: maximum coordinate of its vertices

    void insert(int place, const Way& displacement) {
        std::copy_backward(displacements + place, displacements + count, displacements + count + 1);
        displacements[place] = displacement;
        ++count;
        size = std::max(size, largestOf(displacement.displacement));
    }
};

/// Returns the extreme vertices along both axes: a polygon, or two points if the difference is a segment. It
/// may not contain the origin, which is then outside of the edge that is expanded first.
Polytope polytopeOf(const Displacements& set) {
    Polytope polytope;
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        const Way displacement = set.farthestAlong(direction);
        const bool known = std::any_of(polytope.displacements, polytope.displacements + polytope.count,
                                       [&](const Way& other) {
                                           return distance(other.displacement, displacement.displacement) <=
                                                  kSimplexPrecision * polytope.size;
                                       });
        if (!known) polytope.insert(polytope.count, displacement);
    }
    return polytope;
}

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

/// Computes the shortest displacement that separates two overlapping cores (EPA).
/// @param iterations  those of the search before
DisplacementBetween deepestOverlap(const Displacements& displacements, int iterations) {
    Polytope polytope = polytopeOf(displacements);
    DisplacementBetween result{
        .first = polytope.displacements[0], .second = polytope.displacements[0], .iterations = iterations};
    if (polytope.count < 2) return result;  // two discs with the same centre
    NearestSide side = nearestSide(polytope);
    while (polytope.count < kMaxWays) {
        ++result.iterations;
        const Way displacement = displacements.farthestAlong(side.normal);
        const float out = dot(displacement.displacement, side.normal) - side.distance;
        if (!(out > kSimplexPrecision * polytope.size) || polytope.has(displacement)) break;
        polytope.insert(side.index + 1, displacement);
        side = nearestSide(polytope);
    }
    result.first = polytope.displacements[side.index];
    result.second = polytope.displacements[side.index + 1 < polytope.count ? side.index + 1 : 0];
    // The origin is at this depth inside B - A, so B has to move in the opposite direction to separate.
    result.normal = -side.normal;
    result.distance = -side.distance;
    const Vec2 edge = result.second.displacement - result.first.displacement;
    const float square = lengthSquared(edge);
    if (square > 0.0f) result.part = std::clamp(-dot(result.first.displacement, edge) / square, 0.0f, 1.0f);
    return result;
}

}  // namespace

Distance distanceBetween(const Convex& a, const Convex& b, const Frame& bInA, SimplexCache* cache) {
    const Displacements displacements{a, b, bInA};
    Simplex simplex = startFrom(displacements, cache);
    DisplacementBetween nearest = nearestWay(displacements, simplex);
    if (cache != nullptr) {
        cache->count = static_cast<std::uint8_t>(simplex.count);
        for (int i = 0; i < simplex.count; ++i) {
            cache->a[i] = simplex.displacements[i].indexA;
            cache->b[i] = simplex.displacements[i].indexB;
        }
    }
    if (simplex.count == 3 || nearest.distance <= kSimplexPrecision * sizeOf(simplex))
        nearest = deepestOverlap(displacements, nearest.iterations);
    return {.distance = nearest.distance - a.radius - b.radius,
            .normal = nearest.normal,
            .pointA = lerp(nearest.first.a, nearest.second.a, nearest.part) + nearest.normal * a.radius,
            .pointB = lerp(nearest.first.b, nearest.second.b, nearest.part) - nearest.normal * b.radius,
            .iterations = nearest.iterations};
}

}  // namespace plumb::physics
