#include "core/text.hpp"
#include "physics/ranges.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

using Corners = std::span<const Corner>;

bool isPlace(Vec2 v) { return std::fabs(v.x) <= kLargest && std::fabs(v.y) <= kLargest; }

Error badPlace(const char* where, Vec2 found) {
    return {where,
            format("expected a position within {} m of the body, found ({}, {})", kLargest, found.x, found.y),
            "use metres, not pixels, and move the body rather than its shapes"};
}

/// @param minimum  m; 0 for an optional size
Result<Done> checkSize(const char* where, float found, float minimum) {
    if (found >= minimum && found <= kLargest) return Done{};
    return Error{where, format("expected {} to {} m, found {}", minimum, kLargest, found),
                 "use metres, not pixels, and a size within this range"};
}

/// True if all normals have unit length and are perpendicular to their faces, and all corners are behind all
/// faces.
bool isConvex(Corners corners) {
    float size = 0.0f;
    for (const Corner& corner : corners) {
        const Vec2 displacement = corner.point - corners[0].point;
        size = std::max(size, std::max(std::fabs(displacement.x), std::fabs(displacement.y)));
    }
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

Result<Done> checkCircle(const Geometry& geometry) {
    if (!isPlace(geometry.a)) return badPlace("circle.a", geometry.a);
    return checkSize("circle.radius", geometry.radius, 0.5f * kSmallest);
}

Result<Done> checkCapsule(const Geometry& geometry) {
    if (!isPlace(geometry.a)) return badPlace("capsule.a", geometry.a);
    if (!isPlace(geometry.b)) return badPlace("capsule.b", geometry.b);
    return checkSize("capsule.radius", geometry.radius, 0.5f * kSmallest);
}

Result<Done> checkBox(const Geometry& geometry) {
    if (!isPlace(geometry.a)) return badPlace("box.a", geometry.a);
    const Rot turn = geometry.turn;
    if (!(std::fabs(turn.cos * turn.cos + turn.sin * turn.sin - 1.0f) < 1.0e-3f)) {
        return Error{"box.turn", format("({}, {}) is not a cosine and sine", turn.cos, turn.sin),
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
                     "make it with makeHull()"};
    }
    if (geometry.first > pool.size() || pool.size() - geometry.first < geometry.count) {
        return Error{"polygon.first", "its corners are not in the world",
                     "use createPolygon(), which stores them"};
    }
    const Corners corners = pool.subspan(geometry.first, geometry.count);
    if (!isPlace(geometry.a)) return badPlace("polygon.a", geometry.a);
    for (const Corner& corner : corners) {
        if (!isPlace(corner.point)) return badPlace("polygon.corners", corner.point);
    }
    if (!isConvex(corners)) {
        return Error{"polygon.corners", "the corners do not form a convex polygon with outward normals",
                     "make it with makeHull(); split a concave outline with decompose()"};
    }
    return checkSize("polygon.radius", geometry.radius, 0.0f);
}

Result<Done> checkSegment(const Geometry& geometry) {
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

}  // namespace

Result<Done> checkGeometry(const Geometry& geometry, Corners corners) {
    switch (geometry.kind) {
        case ShapeKind::Circle: return checkCircle(geometry);
        case ShapeKind::Capsule: return checkCapsule(geometry);
        case ShapeKind::Box: return checkBox(geometry);
        case ShapeKind::Polygon: return checkPolygon(geometry, corners);
        case ShapeKind::Segment:
        case ShapeKind::ChainSegment: return checkSegment(geometry);
        case ShapeKind::Count: break;
    }
    return Error{"shape.kind", "expected a kind of shape, found another number", "use a ShapeKind"};
}

}  // namespace plumb::physics
