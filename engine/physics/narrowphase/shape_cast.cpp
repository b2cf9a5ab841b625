#include "physics/narrowphase/shape_cast.hpp"

#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// m: distance that counts as a hit: the accuracy of floats at this distance from the origin.
float touchOf(const Convex& a, const Frame& bInA) {
    const Vec2 far = bInA.position;
    const Vec2 own = a.centre;
    return kTouchDistance +
           4.0f * kRounding * (std::fabs(far.x) + std::fabs(far.y) + std::fabs(own.x) + std::fabs(own.y));
}

}  // namespace

std::optional<ConvexHit> castShape(const Convex& a, const Convex& b, const Frame& bInA, Vec2 displacement) {
    SimplexCache cache;
    ConvexHit hit;
    for (int iteration = 0; iteration < kMaxRounds; ++iteration) {
        const Frame frame{bInA.position + displacement * hit.fraction, bInA.rotation};
        const Distance apart = distanceBetween(a, b, frame, &cache);
        hit.normal = apart.normal;
        hit.point = apart.pointA;
        if (iteration == 0) hit.separation = apart.distance;
        const float speed = -dot(displacement, apart.normal);
        const float touch = touchOf(a, frame);
        if (!(apart.distance > touch)) {
            const bool slides = apart.distance >= -touch && speed <= kAlong * length(displacement);
            return slides ? std::nullopt : std::optional{hit};
        }
        if (!(speed > 0.0f)) return std::nullopt;
        const float next = hit.fraction + apart.distance / speed;
        if (!(next <= 1.0f)) return std::nullopt;
        if (next == hit.fraction) return hit;
        hit.fraction = next;
    }
    return std::nullopt;  // it misses narrowly
}

}  // namespace plumb::physics
