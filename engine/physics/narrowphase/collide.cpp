#include "physics/narrowphase/collide.hpp"

namespace plumb::physics {

namespace {

template <Collide function>
Manifold turned(const Geometry& a, const Geometry& b, std::span<const Corner> corners, const Frame& bInA,
                float speculative) {
    return swapped(function(b, a, corners, inverse(bInA), speculative), bInA);
}

Manifold collideNothing(const Geometry&, const Geometry&, std::span<const Corner>, const Frame&, float) {
    return {};
}

constexpr std::size_t kKinds = static_cast<std::size_t>(ShapeKind::Count);

// Rows: kind of A, columns: kind of B, in the order of ShapeKind.
constexpr Collide kCollide[kKinds][kKinds] = {
    // circle
    {collideCircles, collideCircleConvex, collideCircleBox, collideCircleConvex, collideCircleConvex,
     collideChain},
    // capsule
    {turned<collideCircleConvex>, collideConvex, collideConvex, collideConvex, collideConvex, collideChain},
    // box
    {turned<collideCircleBox>, collideConvex, collideBoxes, collideConvex, collideConvex, collideChain},
    // polygon
    {turned<collideCircleConvex>, collideConvex, collideConvex, collideConvex, collideConvex, collideChain},
    // segment
    {turned<collideCircleConvex>, collideConvex, collideConvex, collideConvex, collideConvex, collideChain},
    // chain segment
    {turned<collideChain>, turned<collideChain>, turned<collideChain>, turned<collideChain>,
     turned<collideChain>, collideNothing},
};

}  // namespace

Collide collideOf(ShapeKind a, ShapeKind b) {
    return kCollide[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
}

Manifold swapped(const Manifold& manifold, const Frame& aInB) {
    Manifold result = manifold;
    result.normal = -rotate(aInB.rotation, manifold.normal);
    for (int i = 0; i < manifold.count; ++i) {
        ManifoldPoint& point = result.points[i];
        point.point = apply(aInB, point.point);
        point.id = static_cast<std::uint16_t>(point.id << 8 | point.id >> 8);
    }
    result.roundA = manifold.roundB;
    result.roundB = manifold.roundA;
    return result;
}

}  // namespace plumb::physics
