#include "physics/narrowphase/collide.hpp"

#include <algorithm>

#include "physics/kernels.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

void putPair(BoxPairs& pairs, int lane, const Geometry& a, const Geometry& b, const Frame& bInA) {
    const Rot rotation = between(a.rotation, bInA.rotation * b.rotation);
    pairs.halfA.set(lane, a.b);
    pairs.halfB.set(lane, b.b);
    pairs.place.set(lane, unrotate(a.rotation, apply(bInA, b.a) - a.a));
    pairs.cosine[lane] = rotation.cos;
    pairs.sine[lane] = rotation.sin;
    pairs.radiusA[lane] = a.radius;
    pairs.radiusB[lane] = b.radius;
}

Manifold manifoldOf(const BoxTouches& touches, int lane, const Geometry& a) {
    Manifold manifold;
    if (!(touches.count[lane] > 0.0f)) return manifold;
    manifold.count = static_cast<int>(touches.count[lane]);
    manifold.normal = rotate(a.rotation, touches.normal.at(lane));
    manifold.roundA = touches.roundA[lane];
    manifold.roundB = touches.roundB[lane];
    for (int i = 0; i < manifold.count; ++i) {
        manifold.points[i] = {a.a + rotate(a.rotation, touches.point[i].at(lane)),
                              touches.separation[i][lane], static_cast<std::uint16_t>(touches.id[i][lane])};
    }
    return manifold;
}

namespace {

/// Minimum distance (m) of two centres at which the direction between them is defined.
constexpr float kNoDistance = 1.0e-9f;

/// Returns a manifold with a single point.
/// @param normal  unit length, from the circle to the other outline
/// @param feature  id of the touching feature of the other outline
Manifold onePoint(const Geometry& circle, Vec2 normal, float separation, float round, std::uint16_t feature) {
    Manifold manifold{.normal = normal, .count = 1, .roundA = circle.radius, .roundB = round};
    manifold.points[0] = {circle.a + normal * (circle.radius + 0.5f * separation), separation, feature};
    return manifold;
}

/// Returns an id for the face or corner of a box in direction `out`.
std::uint16_t featureTowards(Vec2 out) {
    const auto side = [](float way) { return way < 0.0f ? 0 : (way > 0.0f ? 2 : 1); };
    return static_cast<std::uint16_t>(side(out.x) + 3 * side(out.y));
}

Manifold collideCircles(const Geometry& a, const Geometry& b, const Frame& bInA, float speculative) {
    const Vec2 displacement = apply(bInA, b.a) - a.a;
    const float radii = a.radius + b.radius;
    const float reach = radii + speculative;
    const float square = lengthSquared(displacement);
    if (!(square <= reach * reach)) return {};
    const float distance = std::sqrt(square);
    const Vec2 normal = distance > kNoDistance ? displacement / distance : kAnyNormal;
    return onePoint(a, normal, distance - radii, b.radius, 0);
}

Manifold collideCircleBox(const Geometry& circle, const Geometry& box, const Frame& bInA, float speculative) {
    const Rot rotation = bInA.rotation * box.rotation;
    const Vec2 place = unrotate(rotation, circle.a - apply(bInA, box.a));
    const Vec2 inside = max(-box.b, min(place, box.b));
    const Vec2 out = place - inside;
    const float square = lengthSquared(out);
    const float radii = circle.radius + box.radius;
    const float reach = radii + speculative;
    if (!(square <= reach * reach)) return {};

    const float distance = std::sqrt(square);
    if (distance > kNoDistance) {
        const bool atCorner = out.x != 0.0f && out.y != 0.0f;
        return onePoint(circle, rotate(rotation, -out / distance), distance - radii,
                        atCorner ? box.radius : 0.0f, featureTowards(out));
    }
    const Vec2 depth{box.b.x - std::fabs(place.x), box.b.y - std::fabs(place.y)};
    const bool byX = depth.x < depth.y;
    const Vec2 face =
        byX ? Vec2{place.x < 0.0f ? -1.0f : 1.0f, 0.0f} : Vec2{0.0f, place.y < 0.0f ? -1.0f : 1.0f};
    return onePoint(circle, rotate(rotation, -face), -(byX ? depth.x : depth.y) - radii, 0.0f,
                    featureTowards(face));
}

Manifold collideBoxes(const Geometry& a, const Geometry& b, const Frame& bInA, float speculative) {
    constexpr float kFar = 1.0e9f;  // m: boxes in unused lanes are apart, so the kernel can skip work
    BoxPairs pairs{};
    std::fill_n(pairs.place.x, kLanes, kFar);
    BoxTouches touches;
    putPair(pairs, 0, a, b, bInA);
    solverKernels().collideBoxes(pairs, speculative, touches);
    return manifoldOf(touches, 0, a);
}

}  // namespace

Manifold collideCircleConvex(const Geometry& circle, const Geometry& other, std::span<const Corner> corners,
                             const Frame& bInA, float speculative) {
    const ClosestPoint closest = closestPoint(other, corners, applyInverse(bInA, circle.a));
    const float separation = closest.distance - circle.radius;
    if (!(separation <= speculative)) return {};
    return onePoint(circle, -rotate(bInA.rotation, closest.normal), separation,
                    closest.atCorner ? other.radius : 0.0f,
                    static_cast<std::uint16_t>(2 * closest.index + (closest.atCorner ? 1 : 0)));
}

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
