#include "physics/shapes/shape_types.hpp"

#include "core/text.hpp"
#include "physics/ranges.hpp"

namespace plumb::physics {

namespace {

using Corners = std::span<const Corner>;

AABB aroundCircle(const Geometry& geometry, Corners, const Frame& frame) {
    const Vec2 centre = apply(frame, geometry.a);
    return grown({centre, centre}, geometry.radius);
}

AABB aroundTwoPoints(const Geometry& geometry, Corners, const Frame& frame) {
    const Vec2 a = apply(frame, geometry.a);
    const Vec2 b = apply(frame, geometry.b);
    return grown({min(a, b), max(a, b)}, geometry.radius);
}

AABB aroundBox(const Geometry& geometry, Corners, const Frame& frame) {
    const Rot rotation = frame.rotation * geometry.rotation;
    const float c = std::fabs(rotation.cos);
    const float s = std::fabs(rotation.sin);
    const Vec2 centre = apply(frame, geometry.a);
    const Vec2 half{c * geometry.b.x + s * geometry.b.y, s * geometry.b.x + c * geometry.b.y};
    return grown({centre - half, centre + half}, geometry.radius);
}

AABB aroundPolygon(const Geometry& geometry, Corners pool, const Frame& frame) {
    const Corners corners = pool.subspan(geometry.first, geometry.count);
    const Vec2 start = rotate(frame.rotation, corners[0].point);
    AABB box{start, start};
    for (const Corner& corner : corners) {
        const Vec2 point = rotate(frame.rotation, corner.point);
        box = {min(box.min, point), max(box.max, point)};
    }
    return grown({frame.position + box.min, frame.position + box.max}, geometry.radius);
}

/// Distance (m) below which the square of a float loses digits.
constexpr float kNoGap = 1.0e-18f;

/// Returns the position of the nearest point of a segment: 0 at its start, 1 at its end.
float nearestOn(Vec2 start, Vec2 end, Vec2 place) {
    const Vec2 displacement = end - start;
    const float along = dot(place - start, displacement);
    const float square = lengthSquared(displacement);
    if (!(along > 0.0f)) return 0.0f;
    return along < square ? along / square : 1.0f;
}

/// Replaces the first hit if the new hit is earlier.
void keep(std::optional<RayHit>& first, float fraction, Vec2 normal) {
    if (fraction >= 0.0f && fraction <= 1.0f && (!first || fraction < first->fraction))
        first = RayHit{fraction, normal};
}

/// Computes relative to the point of the ray that is nearest to the centre, so that a long ray does not miss
/// a small disc because of rounding.
void castAtDisc(const Ray& ray, Vec2 centre, float radius, std::optional<RayHit>& first) {
    const float length = plumb::length(ray.displacement);
    if (!(length > 0.0f)) return;
    const Vec2 direction = ray.displacement / length;
    const float along = dot(centre - ray.from, direction);
    const Vec2 aside = ray.from + direction * along - centre;
    const float square = radius * radius - lengthSquared(aside);
    if (!(square >= 0.0f)) return;
    const float half = std::sqrt(square);
    keep(first, (along - half) / length, normalized(aside - direction * half));
}

void castAtFace(const Ray& ray, const Corner& corner, Vec2 next, float radius, std::optional<RayHit>& first) {
    const float speed = dot(ray.displacement, corner.normal);
    if (!(speed < 0.0f)) return;
    const float fraction = (dot(corner.point - ray.from, corner.normal) + radius) / speed;
    const Vec2 edge = next - corner.point;
    const float along = dot(ray.from + ray.displacement * fraction - corner.point, edge);
    if (along >= 0.0f && along <= lengthSquared(edge)) keep(first, fraction, corner.normal);
}

/// Tests the offset faces and the discs at the corners, which overlap, so that no ray passes between them.
std::optional<RayHit> castAtRounded(const Convex& convex, const Ray& ray) {
    const Corners corners = convex.corners();
    std::optional<RayHit> first;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 next = corners[i + 1 < corners.size() ? i + 1 : 0].point;
        if (corners.size() > 1) castAtFace(ray, corners[i], next, convex.radius, first);
        if (convex.radius > 0.0f) castAtDisc(ray, corners[i].point, convex.radius, first);
    }
    return first;
}

/// Clips the ray to the half-planes behind all faces.
/// Source: M. Cyrus, J. Beck, "Generalized two- and three-dimensional clipping", 1978.
std::optional<RayHit> castAtSharp(Corners corners, const Ray& ray) {
    float enter = 0.0f;
    float leave = 1.0f;
    std::optional<Vec2> normal;
    for (const Corner& corner : corners) {
        const float depth = dot(corner.normal, corner.point - ray.from);
        const float speed = dot(corner.normal, ray.displacement);
        if (speed < 0.0f) {
            if (depth < enter * speed) {
                enter = depth / speed;
                normal = corner.normal;
            }
        } else if (speed > 0.0f) {
            if (depth < leave * speed) leave = depth / speed;
        } else if (depth < 0.0f) {
            return std::nullopt;
        }
        if (leave < enter) return std::nullopt;
    }
    if (!normal) return std::nullopt;
    return RayHit{enter, *normal};
}

bool isPlace(Vec2 v) { return std::fabs(v.x) <= kLargest && std::fabs(v.y) <= kLargest; }

Error badPlace(const char* where, Vec2 found) {
    return {where,
            format("expected a position within {} m of the body, found ({}, {})", kLargest, found.x, found.y),
            "use metres, not pixels, and move the body instead of its shapes"};
}

/// @param minimum  m; 0 if the size may be 0
Result<Done> checkSize(const char* where, float found, float minimum) {
    if (found >= minimum && found <= kLargest) return Done{};
    return Error{where, format("expected {} to {} m, found {}", minimum, kLargest, found),
                 "use metres, not pixels, and a size within this range"};
}

/// True if normals are of unit length and perpendicular to their faces, and all corners are behind all faces.
bool isConvex(Corners corners) {
    float size = 0.0f;
    for (const Corner& corner : corners) size = std::max(size, largestOf(corner.point - corners[0].point));
    const float slack = 1.0e-3f * size;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner& face = corners[i];
        const Vec2 side = corners[i + 1 < corners.size() ? i + 1 : 0].point - face.point;
        if (!(std::fabs(lengthSquared(face.normal) - 1.0f) < 1.0e-4f)) return false;
        if (!(dot(perpendicular(face.normal), side) > 0.0f && dot(face.normal, side) > -slack)) return false;
        for (const Corner& corner : corners) {
            if (dot(face.normal, corner.point - face.point) > slack) return false;
        }
    }
    return size >= kSmallest;
}

Result<Done> checkCircle(const Geometry& geometry, Corners) {
    if (!isPlace(geometry.a)) return badPlace("circle.a", geometry.a);
    return checkSize("circle.radius", geometry.radius, 0.5f * kSmallest);
}

Result<Done> checkCapsule(const Geometry& geometry, Corners) {
    if (!isPlace(geometry.a)) return badPlace("capsule.a", geometry.a);
    if (!isPlace(geometry.b)) return badPlace("capsule.b", geometry.b);
    return checkSize("capsule.radius", geometry.radius, 0.5f * kSmallest);
}

Result<Done> checkBox(const Geometry& geometry, Corners) {
    if (!isPlace(geometry.a)) return badPlace("box.a", geometry.a);
    const Rot rotation = geometry.rotation;
    if (!(std::fabs(rotation.cos * rotation.cos + rotation.sin * rotation.sin - 1.0f) < 1.0e-3f)) {
        return Error{"box.rotation",
                     format("expected a cosine and sine, found ({}, {})", rotation.cos, rotation.sin),
                     "use rotFromAngle()"};
    }
    if (auto checked = checkSize("box.radius", geometry.radius, 0.0f); !checked) return checked;
    if (auto checked = checkSize("box.b.x", geometry.b.x, 0.5f * kSmallest); !checked) return checked;
    return checkSize("box.b.y", geometry.b.y, 0.5f * kSmallest);
}

Result<Done> checkPolygon(const Geometry& geometry, Corners pool) {
    if (geometry.count < 3 || geometry.count > kMaxCorners) {
        return Error{"polygon.count",
                     format("expected 3 to {} corners, found {}", kMaxCorners, int{geometry.count}),
                     "create it with makeHull()"};
    }
    if (geometry.first > pool.size() || pool.size() - geometry.first < geometry.count) {
        return Error{"polygon.first", "the corners are not in Shapes::corners",
                     "use createPolygon(), which stores them"};
    }
    const Corners corners = pool.subspan(geometry.first, geometry.count);
    if (!isPlace(geometry.a)) return badPlace("polygon.a", geometry.a);
    for (const Corner& corner : corners) {
        if (!isPlace(corner.point)) return badPlace("polygon.corners", corner.point);
    }
    if (!isConvex(corners)) {
        return Error{"polygon.corners", "the corners do not form a convex polygon with outward normals",
                     "create it with makeHull(); split a concave outline with decompose()"};
    }
    return checkSize("polygon.radius", geometry.radius, 0.0f);
}

Result<Done> checkSegment(const Geometry& geometry, Corners) {
    if (!isPlace(geometry.a)) return badPlace("segment.a", geometry.a);
    if (!isPlace(geometry.b)) return badPlace("segment.b", geometry.b);
    const bool isOfChain = geometry.kind == ShapeKind::ChainSegment;
    if (isOfChain && !isPlace(beforeOf(geometry))) return badPlace("segment.before", beforeOf(geometry));
    if (!isPlace(geometry.after)) return badPlace("segment.after", geometry.after);
    if (geometry.radius != 0.0f) {
        return Error{"segment.radius", format("expected 0, found {} m", geometry.radius),
                     "use capsule() for a segment with a radius"};
    }
    return checkSize("segment length", distance(geometry.a, geometry.b), kSmallest);
}

/// Shape types in the order of ShapeKind.
constexpr ShapeType kShapeTypes[] = {
    {"circle", true, aroundCircle, checkCircle},
    {"capsule", true, aroundTwoPoints, checkCapsule},
    {"box", true, aroundBox, checkBox},
    {"polygon", true, aroundPolygon, checkPolygon},
    {"segment", false, aroundTwoPoints, checkSegment},
    {"chain segment", false, aroundTwoPoints, checkSegment},
};
static_assert(std::size(kShapeTypes) == static_cast<std::size_t>(ShapeKind::Count));

}  // namespace

const ShapeType& shapeTypeOf(ShapeKind kind) { return kShapeTypes[static_cast<std::size_t>(kind)]; }

float reachOf(const Geometry& geometry, Corners corners, Vec2 from) {
    const Convex convex = convexOf(geometry, corners);
    const auto squareOf = [&](const Corner& corner) { return lengthSquared(corner.point - from); };
    return std::sqrt(largestOf(convex.corners(), squareOf).value) + convex.radius;
}

ClosestPoint closestPointOf(const Convex& convex, Vec2 place) {
    const Corners corners = convex.corners();
    // The face from which the point has the maximum signed distance.
    const BestCorner face =
        largestOf(corners, [&](const Corner& corner) { return dot(corner.normal, place - corner.point); });
    const Corner& corner = corners[face.index];
    if (convex.count > 2 && face.value <= 0.0f) {
        const float distance = face.value - convex.radius;
        return {place - corner.normal * distance, corner.normal, distance, false, face.index};
    }
    // Outside a convex core, the nearest feature is on the face of maximum distance, or its corner.
    const std::size_t after = face.index + 1 < corners.size() ? face.index + 1 : 0;
    const Vec2 next = corners[after].point;
    const float along = nearestOn(corner.point, next, place);
    const Vec2 nearest = along < 1.0f ? corner.point + (next - corner.point) * along : next;
    const float gap = distance(nearest, place);
    const Vec2 normal = gap > kNoGap ? (place - nearest) / gap : corner.normal;
    return {nearest + normal * convex.radius, normal, gap - convex.radius, along == 0.0f || along == 1.0f,
            along < 1.0f ? face.index : after};
}

std::optional<RayHit> castRay(const Geometry& geometry, Corners corners, const Ray& ray) {
    const bool isChain = geometry.kind == ShapeKind::ChainSegment;
    if (isChain && !(dot(ray.displacement, normalOfChain(geometry)) < 0.0f)) return std::nullopt;
    const Convex convex = convexOf(geometry, corners);
    const ClosestPoint start = closestPointOf(convex, ray.from);
    const bool isRounded = convex.radius > 0.0f;
    if (start.distance <= 0.0f && (isRounded || convex.count > 2)) return RayHit{0.0f, start.normal};
    if (isRounded || convex.count < 3) return castAtRounded(convex, ray);
    return castAtSharp(convex.corners(), ray);
}

Result<Done> checkGeometry(const Geometry& geometry, Corners corners) {
    if (geometry.kind < ShapeKind::Count) return shapeTypeOf(geometry.kind).check(geometry, corners);
    return Error{"shape.kind", "expected a ShapeKind, found another number", "use a constant of this enum"};
}

}  // namespace plumb::physics
