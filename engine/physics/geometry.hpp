#pragma once

#include <cstdint>

#include "math/rect.hpp"
#include "math/rot.hpp"

namespace plumb::physics {

/// A place and a direction. What is written in it is carried along by `apply(frame, …)`.
struct Frame {
    Vec2 position;
    Rot rotation;

    friend constexpr bool operator==(const Frame&, const Frame&) = default;
};

constexpr Vec2 apply(const Frame& frame, Vec2 point) {
    return frame.position + rotate(frame.rotation, point);
}
constexpr Vec2 applyInverse(const Frame& frame, Vec2 point) {
    return unrotate(frame.rotation, point - frame.position);
}
/// The frame that undoes another.
constexpr Frame inverse(const Frame& frame) {
    return {-unrotate(frame.rotation, frame.position), inverse(frame.rotation)};
}
/// First `b`, then `a`.
constexpr Frame operator*(const Frame& a, const Frame& b) {
    return {apply(a, b.position), a.rotation * b.rotation};
}

/// The kinds of outlines. Each has a row in shapes/shape_types.cpp.
enum class ShapeKind : std::uint8_t { Circle, Capsule, Box, Polygon, Segment, ChainSegment, Count };

/// A corner of a polygon and the outward direction of the face from it to the next corner.
struct Corner {
    Vec2 point;
    Vec2 normal;

    friend constexpr bool operator==(const Corner&, const Corner&) = default;
};

/// An outline, written in its body's frame (m). What a member means depends on the kind:
///
///            | a               | b          | turn      | radius            | first, count
///   Circle   | centre          |            |           | of the circle     |
///   Capsule  | start           | end        |           | of its ends       |
///   Box      | centre          | half size  | of the box| of round corners  |
///   Polygon  | centroid        |            |           | of round corners  | its corners in World::corners
///   Segment  | start           | end        |           | 0                 |
///   ChainSegment as Segment, and the neighbours' far ends are beforeOf() and `after`; solid on the side of
///   its normal only, which is perpendicular(b - a) turned back: to the right hand of the way from a to b
///   when y points up, to the left hand on a screen with y down. See normalOfChain(). A neighbour whose far
///   end is no further than the common one does not exist: there the chain ends.
///   A radius of a box or a polygon makes it larger by that much on all sides.
struct Geometry {
    ShapeKind kind = ShapeKind::Box;
    std::uint8_t count = 0;
    std::uint16_t reserved = 0;  ///< no padding: the hash of a world reads the memory as it is
    std::uint32_t first = 0;
    float radius = 0.0f;
    Vec2 a{};
    Vec2 b{0.5f, 0.5f};
    Rot turn{};  ///< of a chain segment its `before`: see beforeOf()
    Vec2 after{};

    friend constexpr bool operator==(const Geometry&, const Geometry&) = default;
};

inline constexpr int kMaxCorners = 32;  ///< of one polygon; World::corners has them in a row

/// Where a chain segment's chain comes from. It has no turn, so this place is written there: shapes are many.
constexpr Vec2 beforeOf(const Geometry& segment) { return {segment.turn.cos, segment.turn.sin}; }

/// The solid side of a chain segment.
inline Vec2 normalOfChain(const Geometry& segment) {
    const Vec2 way = segment.b - segment.a;
    return normalized(Vec2{way.y, -way.x});
}

constexpr Geometry circle(float radius, Vec2 centre = {}) {
    return {.kind = ShapeKind::Circle, .radius = radius, .a = centre, .b = {}};
}
constexpr Geometry capsule(Vec2 start, Vec2 end, float radius) {
    return {.kind = ShapeKind::Capsule, .radius = radius, .a = start, .b = end};
}
constexpr Geometry box(Vec2 half, Vec2 centre = {}, Rot turn = {}, float radius = 0.0f) {
    return {.kind = ShapeKind::Box, .radius = radius, .a = centre, .b = half, .turn = turn};
}
constexpr Geometry segment(Vec2 start, Vec2 end) {
    return {.kind = ShapeKind::Segment, .a = start, .b = end};
}
/// From `start` to `end`, in a chain that comes from `before` and goes on to `after`.
constexpr Geometry chainSegment(Vec2 before, Vec2 start, Vec2 end, Vec2 after) {
    return {
        .kind = ShapeKind::ChainSegment, .a = start, .b = end, .turn = {before.x, before.y}, .after = after};
}

}  // namespace plumb::physics
