#include "physics/narrowphase/distance.hpp"

#include "physics/narrowphase/minkowski.hpp"

namespace plumb::physics {

namespace {

/// More than any pair of outlines with kMaxCorners needs; a safeguard against endless loops due to rounding.
constexpr int kMostIterations = 2 * kMaxCorners;
/// Ratio to the size of the simplex: cores closer than this count as touching, as their distance has no
/// reliable direction.
constexpr float kTouching = 1.0e-6f;

/// A simplex of up to three points of the Minkowski difference.
struct Simplex {
    Way ways[3];
    int count = 0;
    float part = 0.0f;  ///< of two points: where between them is the point nearest to the origin

    void keep(int i) {
        ways[0] = ways[i];
        count = 1;
    }
};

/// Reduces a segment to the point of it that is nearest to the origin: an end, or `part` between 0 and 1.
void reduceTwo(Simplex& simplex) {
    const Vec2 first = simplex.ways[0].way;
    const Vec2 edge = simplex.ways[1].way - first;
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
    float least = 1.0e30f;
    const Vec2 a = simplex.ways[0].way;
    const Vec2 b = simplex.ways[1].way;
    const Vec2 c = simplex.ways[2].way;
    const float area = cross(b - a, c - a);
    const float sign = area < 0.0f ? -1.0f : 1.0f;
    bool inside = area != 0.0f;
    for (int i = 0; i < 3; ++i) {
        Simplex side{{simplex.ways[i], simplex.ways[(i + 1) % 3], {}}, 2, 0.0f};
        inside = inside && sign * cross(side.ways[0].way, side.ways[1].way) > 0.0f;
        reduceTwo(side);
        const Vec2 place =
            side.count == 1 ? side.ways[0].way : lerp(side.ways[0].way, side.ways[1].way, side.part);
        const float square = lengthSquared(place);
        if (square < least) {
            least = square;
            best = side;
        }
    }
    if (!inside) simplex = best;
}

Simplex startFrom(const Ways& ways, const SimplexCache* cache) {
    Simplex simplex;
    if (cache != nullptr && cache->count <= 3) {
        for (int i = 0; i < cache->count; ++i) {
            if (cache->a[i] >= ways.a.count || cache->b[i] >= ways.b.count) continue;
            const Way way = ways.at(cache->a[i], cache->b[i]);
            bool known = false;
            for (int k = 0; k < simplex.count; ++k) known = known || simplex.ways[k] == way;
            if (!known) simplex.ways[simplex.count++] = way;
        }
    }
    if (simplex.count == 0) {
        const Vec2 towards = ways.a.centre - apply(ways.bInA, ways.b.centre);
        simplex.ways[simplex.count++] = ways.farthestAlong(towards);
    }
    return simplex;
}

float sizeOf(const Simplex& simplex) {
    float size = 0.0f;
    for (int i = 0; i < simplex.count; ++i) {
        size = std::max(size, std::max(std::fabs(simplex.ways[i].a.x), std::fabs(simplex.ways[i].a.y)));
        size = std::max(size, std::max(std::fabs(simplex.ways[i].b.x), std::fabs(simplex.ways[i].b.y)));
    }
    return size;
}

/// The distance of the simplex from the origin. Along a segment it is measured by the perpendicular, which
/// stays accurate when the outlines almost touch.
WayBetween nearestOf(const Simplex& simplex) {
    WayBetween nearest{simplex.ways[0], simplex.ways[0], 0.0f, kAnyNormal, 0.0f, 0};
    if (simplex.count == 1) {
        nearest.distance = length(simplex.ways[0].way);
        if (nearest.distance > 0.0f) nearest.normal = simplex.ways[0].way / nearest.distance;
        return nearest;
    }
    nearest.second = simplex.ways[1];
    nearest.part = simplex.part;
    nearest.normal = normalized(perpendicular(nearest.second.way - nearest.first.way));
    nearest.distance = dot(nearest.normal, nearest.first.way);
    if (nearest.distance < 0.0f) {
        nearest.normal = -nearest.normal;
        nearest.distance = -nearest.distance;
    }
    return nearest;
}

/// The GJK iteration. @return  the shortest connection of the cores; if they overlap, the simplex has three
/// points or the distance is near 0
WayBetween nearestWay(const Ways& ways, Simplex& simplex) {
    WayBetween nearest;
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
        if (iteration == kMostIterations || nearest.distance <= kTouching * sizeOf(simplex)) return nearest;
        const Way way = ways.farthestAlong(-nearest.normal);
        const float nearer = nearest.distance - dot(way.way, nearest.normal);
        if (nearer <= kTouching * nearest.distance) return nearest;
        for (int i = 0; i < simplex.count; ++i) {
            if (simplex.ways[i] == way) return nearest;
        }
        simplex.ways[simplex.count++] = way;
    }
}

}  // namespace

Distance distanceBetween(const Convex& a, const Convex& b, const Frame& bInA, SimplexCache* cache) {
    const Ways ways{a, b, bInA};
    Simplex simplex = startFrom(ways, cache);
    WayBetween nearest = nearestWay(ways, simplex);
    if (cache != nullptr) {
        cache->count = static_cast<std::uint8_t>(simplex.count);
        for (int i = 0; i < simplex.count; ++i) {
            cache->a[i] = simplex.ways[i].indexA;
            cache->b[i] = simplex.ways[i].indexB;
        }
    }
    if (simplex.count == 3 || nearest.distance <= kTouching * sizeOf(simplex)) {
        const int before = nearest.iterations;
        nearest = deepestOverlap(ways);
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
