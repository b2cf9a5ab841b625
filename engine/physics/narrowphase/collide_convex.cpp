#include "physics/narrowphase/collide.hpp"
#include "physics/narrowphase/reference_face.hpp"

namespace plumb::physics {

Manifold collideConvex(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                       const Frame& bInA, float speculative) {
    const Convex convexA = convexOf(a, corners);
    const Convex convexB = convexOf(b, corners);
    if (convexA.count == 1) {  // a capsule so short that it is a disc
        return collideCircleConvex(circle(a.radius, convexA.centre), b, corners, bInA, speculative);
    }
    if (convexB.count == 1) {
        const Frame aInB = inverse(bInA);
        return swapped(collideCircleConvex(circle(b.radius, convexB.centre), a, corners, aInB, speculative),
                       bInA);
    }
    MovedCorners moved;
    return collideSides(sideOf(convexA), moved.moved(convexB, bInA), speculative);
}

}  // namespace plumb::physics
