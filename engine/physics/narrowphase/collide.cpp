#include "physics/narrowphase/collide.hpp"

#include <algorithm>

#include "physics/solver/kernels.hpp"

namespace plumb::physics {

void putPair(BoxPairs& pairs, int lane, const Geometry& a, const Geometry& b, const Frame& bInA) {
    const Vec2 displacement = unrotate(a.turn, apply(bInA, b.a) - a.a);
    const Rot turn = between(a.turn, bInA.rotation * b.turn);
    pairs.halfAx[lane] = a.b.x;
    pairs.halfAy[lane] = a.b.y;
    pairs.halfBx[lane] = b.b.x;
    pairs.halfBy[lane] = b.b.y;
    pairs.x[lane] = displacement.x;
    pairs.y[lane] = displacement.y;
    pairs.cosine[lane] = turn.cos;
    pairs.sine[lane] = turn.sin;
    pairs.radiusA[lane] = a.radius;
    pairs.radiusB[lane] = b.radius;
}

Manifold manifoldOf(const BoxTouches& touches, int lane, const Geometry& a) {
    Manifold manifold;
    if (!(touches.count[lane] > 0.0f)) return manifold;
    manifold.count = static_cast<int>(touches.count[lane]);
    manifold.normal = rotate(a.turn, {touches.normalX[lane], touches.normalY[lane]});
    manifold.roundA = touches.roundA[lane];
    manifold.roundB = touches.roundB[lane];
    for (int i = 0; i < manifold.count; ++i) {
        manifold.points[i] = {a.a + rotate(a.turn, {touches.pointX[i][lane], touches.pointY[i][lane]}),
                              touches.separation[i][lane], static_cast<std::uint16_t>(touches.id[i][lane])};
    }
    return manifold;
}

namespace {

Manifold collideBoxes(const Geometry& a, const Geometry& b, const Frame& bInA, float speculative) {
    constexpr float kFar =
        1.0e9f;  // m: lanes without a pair are apart, so the kernel may skip what others need
    BoxPairs pairs{};
    std::fill_n(pairs.x, kLanes, kFar);
    BoxTouches touches;
    putPair(pairs, 0, a, b, bInA);
    solverKernels().collideBoxes(pairs, speculative, touches);
    return manifoldOf(touches, 0, a);
}

}  // namespace

Manifold collide(const Geometry& a, const Geometry& b, std::span<const Corner> corners, const Frame& bInA,
                 float speculative) {
    const auto both = [&](ShapeKind kind) { return a.kind == kind && b.kind == kind; };
    if (both(ShapeKind::ChainSegment)) return {};
    if (both(ShapeKind::Circle)) return collideCircles(a, b, bInA, speculative);
    if (b.kind == ShapeKind::ChainSegment) return collideChain(a, b, corners, bInA, speculative);
    if (a.kind == ShapeKind::ChainSegment || b.kind == ShapeKind::Circle)
        return swapped(collide(b, a, corners, inverse(bInA), speculative), bInA);
    if (a.kind == ShapeKind::Circle) {
        return b.kind == ShapeKind::Box ? collideCircleBox(a, b, bInA, speculative)
                                        : collideCircleConvex(a, b, corners, bInA, speculative);
    }
    return both(ShapeKind::Box) ? collideBoxes(a, b, bInA, speculative)
                                : collideConvex(a, b, corners, bInA, speculative);
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
