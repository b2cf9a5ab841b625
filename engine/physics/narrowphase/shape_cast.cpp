#include "physics/narrowphase/shape_cast.hpp"

namespace plumb::physics {

namespace {

constexpr int kMostIterations = 48;

/// m: near enough to be a hit: what floats can tell apart at this distance from the origin.
float touchOf(const Convex& a, const Frame& bInA) {
    const Vec2 far = bInA.position;
    const Vec2 own = a.centre;
    return 1.0e-5f + 2.0e-6f * (std::fabs(far.x) + std::fabs(far.y) + std::fabs(own.x) + std::fabs(own.y));
}

}  // namespace

std::optional<CastHit> castShape(const Convex& a, const Convex& b, const Frame& bInA, Vec2 way) {
    SimplexCache cache;
    CastHit hit;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        const Frame frame{bInA.position + way * hit.fraction, bInA.rotation};
        const Distance apart = distanceBetween(a, b, frame, &cache);
        hit.normal = apart.normal;
        hit.point = apart.pointA;
        if (!(apart.distance > touchOf(a, frame))) {
            if (iteration == 0 && apart.distance < 0.0f) hit.overlap = -apart.distance;
            return hit;
        }
        const float speed = -dot(way, apart.normal);
        if (!(speed > 0.0f)) return std::nullopt;
        const float next = hit.fraction + apart.distance / speed;
        if (!(next <= 1.0f)) return std::nullopt;
        if (next == hit.fraction) return hit;
        hit.fraction = next;
    }
    return std::nullopt;  // it grazes past
}

}  // namespace plumb::physics
