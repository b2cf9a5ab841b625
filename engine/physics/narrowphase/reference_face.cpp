#include "physics/narrowphase/reference_face.hpp"

#include <utility>

namespace plumb::physics {

namespace {

std::size_t next(std::span<const Corner> corners, std::size_t i) {
    return i + 1 < corners.size() ? i + 1 : 0;
}

/// Returns a manifold with a single point between two (rounded) corners.
Manifold touchAtCorners(const CornerPair& pair, const Side& reference, const Side& other, bool isB,
                        float speculative) {
    const Vec2 direction = pair.displacement / pair.distance;
    const float separation = pair.distance - reference.radius - other.radius;
    const float middle = reference.radius + 0.5f * separation;
    const Vec2 point = reference.corners[pair.reference].point + direction * middle;
    ManifoldMaker maker{.speculative = speculative};
    maker.add(point, separation, isB ? pair.other : pair.reference, isB ? pair.reference : pair.other);
    maker.manifold.normal = isB ? -direction : direction;
    maker.manifold.roundA = isB ? other.radius : reference.radius;
    maker.manifold.roundB = isB ? reference.radius : other.radius;
    return maker.manifold;
}

/// Collides two convex outlines with at least two corners each.
/// Source: separating axes after C. Ericson, "Real-Time Collision Detection", 2005, 4.4; clipping of edges
/// after E. Catto, "Contact Manifolds", GDC 2007
Manifold collideSides(const Side& a, const Side& b, float speculative) {
    const float reach = speculative + a.radius + b.radius;
    const FaceGap gapA = widestGap(a.corners, b.corners);
    if (!(gapA.gap <= reach)) return {};
    const FaceGap gapB = widestGap(b.corners, a.corners);
    if (!(gapB.gap <= reach)) return {};

    const Corner& face = a.corners[gapA.face];
    const bool isB = gapB.gap > gapA.gap + faceTieOf(dot(face.normal, face.point - a.centre) + a.radius);
    const Side& reference = isB ? b : a;
    const Side& other = isB ? a : b;
    const EdgeOnEdge edges = edgeOnEdge(reference, isB ? gapB.face : gapA.face, other);
    const float gap = isB ? gapB.gap : gapA.gap;
    if (gap > -kBlur * edges.length) {
        if (const auto pair = nearestCorners(edges, reference, other))
            return touchAtCorners(*pair, reference, other, isB, speculative);
    }
    return touchEdge(edges, reference, other, isB, speculative);
}

}  // namespace

FaceGap widestGap(std::span<const Corner> faces, std::span<const Corner> other) {
    FaceGap widest{0, -1.0e30f};
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Vec2 normal = faces[i].normal;
        const auto depthOf = [&](const Corner& corner) { return -dot(normal, corner.point); };
        const float gap = -largestOf(other, depthOf).value - dot(normal, faces[i].point);
        if (gap > widest.gap) widest = {i, gap};
    }
    return widest;
}

EdgeOnEdge edgeOnEdge(const Side& reference, std::size_t face, const Side& other) {
    const Corner& corner = reference.corners[face];
    EdgeOnEdge edges{
        .origin = corner.point, .normal = corner.normal, .tangent = perpendicular(corner.normal)};
    edges.face = face;
    edges.length = dot(reference.corners[next(reference.corners, face)].point - corner.point, edges.tangent);
    // Both outlines have the same orientation, so the incident edge runs against the reference edge.
    edges.end = faceAgainst(other.corners, corner.normal);
    edges.start = next(other.corners, edges.end);
    const auto seen = [&](std::size_t i) {
        const Vec2 displacement = other.corners[i].point - edges.origin;
        return Vec2{dot(displacement, edges.tangent), dot(displacement, edges.normal)};
    };
    edges.low = seen(edges.start);
    edges.high = seen(edges.end);
    if (edges.high.x < edges.low.x) {
        std::swap(edges.low, edges.high);
        std::swap(edges.start, edges.end);
    }
    return edges;
}

std::optional<CornerPair> nearestCorners(const EdgeOnEdge& edges, const Side& reference, const Side& other) {
    const auto beyond = [&](Vec2 place) {
        return place.x < 0.0f ? -place.x : place.x > edges.length ? place.x - edges.length : 0.0f;
    };
    const float lowBeyond = beyond(edges.low);
    const float highBeyond = beyond(edges.high);
    const bool high = highBeyond * highBeyond + edges.high.y * edges.high.y <
                      lowBeyond * lowBeyond + edges.low.y * edges.low.y;
    const float nearBeyond = high ? highBeyond : lowBeyond;
    if (!(nearBeyond > 0.0f)) return std::nullopt;
    const Vec2 near = high ? edges.high : edges.low;
    const Vec2 far = high ? edges.low : edges.high;
    const bool atStart = near.x < 0.0f;
    const Vec2 corner{atStart ? 0.0f : edges.length, 0.0f};
    // If the incident edge passes in front of the corner, the edge touches, not its end.
    const bool apart = edges.high.x < 0.0f || edges.low.x > edges.length;
    if (!apart && dot(corner - near, far - near) > 0.0f) return std::nullopt;
    // A corner that extends only slightly beyond the end of a nearly parallel face counts as in front of the
    // face, so that boxes of equal size keep both points. The error is 0.01 % of the distance.
    const bool past =
        nearBeyond > kParallel * near.y ||
        (far.y - near.y) * nearBeyond > kParallel * kParallel * near.y * std::fabs(far.x - near.x);
    if (!apart && !past) return std::nullopt;

    CornerPair pair{.reference = atStart ? edges.face : next(reference.corners, edges.face),
                    .other = high ? edges.end : edges.start};
    const Vec2 place = other.corners[pair.other].point;
    pair.displacement = place - reference.corners[pair.reference].point;
    pair.distance = length(pair.displacement);
    const float blur = kBlur * (std::fabs(place.x) + std::fabs(place.y));
    if (!(pair.distance > blur)) return std::nullopt;
    return pair;
}

Manifold touchEdge(const EdgeOnEdge& edges, const Side& reference, const Side& other, bool isB,
                   float speculative) {
    const float radii = reference.radius + other.radius;
    ManifoldMaker maker{.speculative = speculative};
    bool isCorner = false;
    const auto add = [&](Vec2 place, std::size_t corner, std::size_t facing, bool cut) {
        const float separation = place.y - radii;
        const float middle = reference.radius + 0.5f * separation;
        const Vec2 point = edges.origin + edges.tangent * place.x + edges.normal * middle;
        if (maker.add(point, separation, isB ? facing : corner, isB ? corner : facing)) isCorner = !cut;
    };
    const Vec2 displacement = edges.high - edges.low;
    const auto clipped = [&](float along) {
        return Vec2{along, edges.low.y + displacement.y * ((along - edges.low.x) / displacement.x)};
    };
    const bool cutLow = edges.low.x < 0.0f;
    const bool cutHigh = edges.high.x > edges.length;
    if (edges.high.x < 0.0f || edges.low.x > edges.length) {
        // The edges just miss each other due to rounding: uses the deeper end only.
        const bool low = edges.low.y < edges.high.y;
        const float along = edges.high.x < 0.0f ? 0.0f : edges.length;
        add({along, low ? edges.low.y : edges.high.y}, edges.face, low ? edges.start : edges.end, true);
    } else {
        add(cutLow ? clipped(0.0f) : edges.low, edges.face, edges.start, cutLow);
        add(cutHigh ? clipped(edges.length) : edges.high, next(reference.corners, edges.face), edges.end,
            cutHigh);
    }
    Manifold& manifold = maker.manifold;
    manifold.normal = isB ? -edges.normal : edges.normal;
    if (manifold.count == 1 && isCorner) (isB ? manifold.roundA : manifold.roundB) = other.radius;
    return manifold;
}

Manifold touchFace(const Side& a, std::size_t face, const Side& b, float speculative, Vec2 beyond) {
    EdgeOnEdge edges = edgeOnEdge(a, face, b);
    edges.origin -= beyond.x * edges.tangent;
    edges.low.x += beyond.x;
    edges.high.x += beyond.x;
    edges.length += beyond.x + beyond.y;
    if (edges.high.x < 0.0f || edges.low.x > edges.length) return {};
    Manifold manifold = touchEdge(edges, a, b, false, speculative);
    if (b.corners.size() == 1 && manifold.count > 0) {  // a disc
        manifold.count = 1;
        manifold.roundB = b.radius;
    }
    return manifold;
}

Manifold collideConvex(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                       const Frame& bInA, float speculative) {
    const Convex convexA = convexOf(a, corners);
    const Convex convexB = convexOf(b, corners);
    if (convexA.count == 1) {  // a capsule without length is a disc
        return collideCircleConvex(circle(a.radius, convexA.centre), b, corners, bInA, speculative);
    }
    if (convexB.count == 1) return swapped(collideConvex(b, a, corners, inverse(bInA), speculative), bInA);
    MovedCorners moved;
    return collideSides(sideOf(convexA), moved.moved(convexB, bInA), speculative);
}

}  // namespace plumb::physics
