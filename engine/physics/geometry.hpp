#pragma once

#include <algorithm>
#include <cstdint>

#include "math/rect.hpp"
#include "math/rot.hpp"

namespace plumb::physics {

/// A vector of doubles, for differences of large values and for exact products of floats.
struct Double2 {
    double x = 0.0;
    double y = 0.0;
};
constexpr Double2 wide(Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
constexpr Double2 operator+(Double2 a, Double2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Double2 operator-(Double2 a, Double2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Double2 operator*(Double2 a, double s) { return {a.x * s, a.y * s}; }
constexpr double dot(Double2 a, Double2 b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Double2 a, Double2 b) { return a.x * b.y - a.y * b.x; }

/// The larger of the magnitudes of two coordinates.
inline float largestOf(Vec2 v) { return std::max(std::fabs(v.x), std::fabs(v.y)); }

/// A coordinate frame. apply(frame, point) maps a point from the frame to its parent space.
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
/// The inverse map: inverse(f) * f is the identity.
constexpr Frame inverse(const Frame& frame) {
    return {-unrotate(frame.rotation, frame.position), inverse(frame.rotation)};
}
/// Applies `b` first, then `a`.
constexpr Frame operator*(const Frame& a, const Frame& b) {
    return {apply(a, b.position), a.rotation * b.rotation};
}

/// The mass properties of a filled outline, or of a body in the frame of its shapes.
struct MassProperties {
    float mass = 0.0f;     ///< kg
    Vec2 centre;           ///< m: centre of mass; geometric centre of an outline without area
    float inertia = 0.0f;  ///< kg m2, about the centre of mass; 0: cannot rotate
};

/// The kinds of outlines. Each has a row in shapes/shape_types.cpp.
enum class ShapeKind : std::uint8_t { Circle, Capsule, Box, Polygon, Segment, ChainSegment, Count };

/// A corner of a polygon and the outward normal of the edge from it to the next corner.
struct Corner {
    Vec2 point;
    Vec2 normal;

    friend constexpr bool operator==(const Corner&, const Corner&) = default;
};

/// An outline in the frame of its body (m). The meaning of a member depends on the kind:
///
///            | a               | b          | rotation      | radius            | first, count
///   Circle   | centre          |            |           | of the circle     |
///   Capsule  | start           | end        |           | of its ends       |
///   Box      | centre          | half size  | rotation  | of round corners  |
///   Polygon  | centroid        |            |           | of round corners  | its corners in Shapes::corners
///   Segment  | start           | end        |           | 0                 |
///
/// A ChainSegment is a Segment with ghost vertices: the far ends of its neighbours, beforeOf() and `after`.
/// It is solid only on the side of its normal (see normalOfChain()): to the right of the direction from a to
/// b when y points up, to the left on a screen with y down. Where a ghost vertex equals the end next to it,
/// there is no neighbour and the chain ends.
///
/// The radius of a box or a polygon enlarges it by that amount on all sides.
struct Geometry {
    ShapeKind kind = ShapeKind::Box;
    std::uint8_t count = 0;
    std::uint16_t reserved = 0;  ///< instead of padding: hashOf() reads raw memory
    std::uint32_t first = 0;
    float radius = 0.0f;
    Vec2 a{};
    Vec2 b{0.5f, 0.5f};
    Rot rotation{};  ///< rotation; a chain segment stores its first ghost vertex here: see beforeOf()
    Vec2 after{};

    friend constexpr bool operator==(const Geometry&, const Geometry&) = default;
};

inline constexpr int kMaxCorners = 32;  ///< maximum number of corners of a polygon

/// The ghost vertex before a chain segment. Stored in `rotation`, which a segment does not need.
constexpr Vec2 beforeOf(const Geometry& segment) { return {segment.rotation.cos, segment.rotation.sin}; }

/// The unit normal of the solid side of a chain segment.
inline Vec2 normalOfChain(const Geometry& segment) {
    const Vec2 displacement = segment.b - segment.a;
    return normalized(Vec2{displacement.y, -displacement.x});
}

constexpr Geometry circle(float radius, Vec2 centre = {}) {
    return {.kind = ShapeKind::Circle, .radius = radius, .a = centre, .b = {}};
}
constexpr Geometry capsule(Vec2 start, Vec2 end, float radius) {
    return {.kind = ShapeKind::Capsule, .radius = radius, .a = start, .b = end};
}
constexpr Geometry box(Vec2 half, Vec2 centre = {}, Rot rotation = {}, float radius = 0.0f) {
    return {.kind = ShapeKind::Box, .radius = radius, .a = centre, .b = half, .rotation = rotation};
}
constexpr Geometry segment(Vec2 start, Vec2 end) {
    return {.kind = ShapeKind::Segment, .a = start, .b = end};
}
/// A segment from `start` to `end`, with the ghost vertices `before` and `after`.
constexpr Geometry chainSegment(Vec2 before, Vec2 start, Vec2 end, Vec2 after) {
    return {.kind = ShapeKind::ChainSegment,
            .a = start,
            .b = end,
            .rotation = {before.x, before.y},
            .after = after};
}

/// Surface numbers from this one on are reserved for the library.
inline constexpr std::uint32_t kOwnSurfaces = 1u << 28;

/// Material and collision filter of a shape; its outline is a Geometry.
struct ShapeDefinition {
    float density = 1.0f;            ///< kg/m2; 0: no mass
    float friction = 0.6f;           ///< Coulomb coefficient; a contact uses the geometric mean of the two
    float bounciness = 0.0f;         ///< coefficient of restitution; a contact uses the larger of the two
    float rollingResistance = 0.0f;  ///< ratio to the radius; a contact uses the larger of the two
    /// m/s along the surface, as of a conveyor belt. Positive: in the direction of the outward normal rotated
    /// from x towards y, so bodies on it move to the right if y points down, and to the left if y points up.
    float surfaceSpeed = 0.0f;
    std::uint32_t layers = 1;          ///< bits: layers of the shape
    std::uint32_t mask = 0xffffffffu;  ///< bits: layers with which it collides; both shapes must allow it
    std::int32_t group = 0;  ///< shapes of the same group always collide (above 0) or never (below 0)
    /// A sensor: reports overlaps at the start of a step, wakes the overlapping bodies, exerts no forces.
    bool isTrigger = false;
    bool oneWay = false;                ///< stops only bodies that come from the side of `oneWayDirection`
    Vec2 oneWayDirection{0.0f, -1.0f};  ///< outward normal of the solid side, in the body's frame
    bool reportsContacts = true;        ///< its contacts produce events
    std::uint64_t user = 0;             ///< user data: a number of the caller, not used by the library
    /// Shapes with the same number form one surface, also across bodies: events report when a body begins or
    /// ends to touch the surface, not when it passes from shape to shape. 0: a surface of its own; for 0,
    /// createChain() assigns a number to the chain. Callers may use numbers below kOwnSurfaces.
    std::uint32_t surface = 0;
    /// For a border between two kinds of terrain: layers and mask of the terrain in front of it. Shapes that
    /// collide with that terrain ignore the border, because the terrain stops them first. 0: no such border.
    std::uint32_t frontLayers = 0;
    std::uint32_t frontMask = 0;

    friend constexpr bool operator==(const ShapeDefinition&, const ShapeDefinition&) = default;
};

}  // namespace plumb::physics
