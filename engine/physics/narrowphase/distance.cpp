#include "physics/narrowphase/distance.hpp"

#include "physics/narrowphase/minkowski.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// More than any pair of outlines with kMaxCorners needs; a safeguard against endless loops due to rounding.
constexpr int kMaxIterations = 2 * kMaxCorners;

/// A simplex of up to three points of the Minkowski difference.
struct Simplex {
    Way displacements[3];
    int count = 0;
    float part = 0.0f;  ///< of two points: where between them is the point nearest to the origin

    void keep(int i) {
        displacements[0] = displacements[i];
        count = 1;
    }
};

/// Reduces a segment to the point of it that is nearest to the origin: an end, or `part` between 0 and 1.
void reduceTwo(Simplex& simplex) {
    const Vec2 first = simplex.displacements[0].displacement;
    const Vec2 edge = simplex.displacements[1].displacement - first;
    const float along = -dot(first, edge);
    const float square = lengthSquared(edge);
    if (!(along > 0.0f)) return simplex.keep(0);
    if (!(along < square)) return simplex.keep(1);
    simplex.part = along / square;
}

/// Reduces a triangle to the corner or side that is nearest to the origin; keeps all three points if the
/// origin is inside.
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
        Simplex side{{simplex.displacements[i], simplex.displacements[(i + 1) % 3], {}}, 2, 0.0f};
        inside = inside &&
                 sign * cross(side.displacements[0].displacement, side.displacements[1].displacement) > 0.0f;
        reduceTwo(side);
        const Vec2 place = side.count == 1 ? side.displacements[0].displacement
                                           : lerp(side.displacements[0].displacement,
                                                  side.displacements[1].displacement, side.part);
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
            bool known = false;
            for (int k = 0; k < simplex.count; ++k) known = known || simplex.displacements[k] == displacement;
            if (!known) simplex.displacements[simplex.count++] = displacement;
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
    for (int i = 0; i < simplex.count; ++i) {
        size = std::max(
            size, std::max(std::fabs(simplex.displacements[i].a.x), std::fabs(simplex.displacements[i].a.y)));
        size = std::max(
            size, std::max(std::fabs(simplex.displacements[i].b.x), std::fabs(simplex.displacements[i].b.y)));
    }
    return size;
}

/// The distance of the simplex from the origin. Along a segment it is measured by the perpendicular, which
/// stays accurate when the outlines almost touch.
DisplacementBetween nearestOf(const Simplex& simplex) {
    DisplacementBetween nearest{
        simplex.displacements[0], simplex.displacements[0], 0.0f, kAnyNormal, 0.0f, 0};
    if (simplex.count == 1) {
        nearest.distance = length(simplex.displacements[0].displacement);
        if (nearest.distance > 0.0f)
            nearest.normal = simplex.displacements[0].displacement / nearest.distance;
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

/// The GJK iteration. @return  the shortest connection of the cores; if they overlap, the simplex has three
/// points or the distance is near 0
DisplacementBetween nearestWay(const Displacements& displacements, Simplex& simplex) {
    DisplacementBetween nearest;
    for (int iteration = 1;; ++iteration) {
        if (simplex.count == 2) reduceTwo(simplex);
        if (simplex.count == 3) reduceThree(simplex);
        if (simplex.count == 3) {
            nearest.iterations = iteration;
            nearest.distance = 0.0f;
            return nearest;
        }
        nearest = nearestOf(simplex);
        nearest.iterations = iteration;
        if (iteration == kMaxIterations || nearest.distance <= kSimplexPrecision * sizeOf(simplex))
            return nearest;
        const Way displacement = displacements.farthestAlong(-nearest.normal);
        const float nearer = nearest.distance - dot(displacement.displacement, nearest.normal);
        if (nearer <= kSimplexPrecision * nearest.distance) return nearest;
        for (int i = 0; i < simplex.count; ++i) {
            if (simplex.displacements[i] == displacement) return nearest;
        }
        simplex.displacements[simplex.count++] = displacement;
    }
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
    if (simplex.count == 3 || nearest.distance <= kSimplexPrecision * sizeOf(simplex)) {
        const int before = nearest.iterations;
        nearest = deepestOverlap(displacements);
        nearest.iterations += before;
    }
    Distance result{.distance = nearest.distance - a.radius - b.radius,
                    .normal = nearest.normal,
                    .iterations = nearest.iterations};
    result.pointA = lerp(nearest.first.a, nearest.second.a, nearest.part) + nearest.normal * a.radius;
    result.pointB = lerp(nearest.first.b, nearest.second.b, nearest.part) - nearest.normal * b.radius;
    return result;
}

}  // namespace plumb::physics
