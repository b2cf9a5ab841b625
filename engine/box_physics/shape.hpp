#pragma once

#include <array>
#include <cstdint>

#include "math/rect.hpp"

namespace plumb::box_physics {

enum class ShapeKind : std::uint8_t { Box, Circle, Tiles };

/// The outline of a body. Boxes stay axis aligned in this cut.
struct Shape {
    ShapeKind kind = ShapeKind::Box;
    Vec2 centre;              ///< m from the body's position
    Vec2 half{0.5f, 0.5f};    ///< m: half the size of the bounds; both are the radius for a circle
    std::uint32_t field = 0;  ///< of Tiles: which of the world's tile fields

    static Shape box(Vec2 half, Vec2 centre = {}) { return {ShapeKind::Box, centre, half, 0}; }
    static Shape circle(float radius, Vec2 centre = {}) {
        return {ShapeKind::Circle, centre, {radius, radius}, 0};
    }
    [[nodiscard]] AABB boundsAt(Vec2 position) const {
        return {position + centre - half, position + centre + half};
    }
    friend bool operator==(const Shape&, const Shape&) = default;
};

/// A convex outline of at most eight corners, in order so that its faces' normals point outwards.
struct Convex {
    static constexpr int kMaxPoints = 8;

    std::array<Vec2, kMaxPoints> points{};   ///< m; face i goes from point i to point i + 1
    std::array<Vec2, kMaxPoints> normals{};  ///< length 1, outwards
    int count = 0;
    std::uint32_t inner = 0;  ///< bit i: face i lies against a neighbour, nobody can touch it from outside

    [[nodiscard]] bool isInner(int face) const { return (inner >> face & 1u) != 0; }
    [[nodiscard]] int next(int i) const { return i + 1 == count ? 0 : i + 1; }
};

/// The outline through these points, wound so that normals point outwards. Points must be convex.
Convex convexFrom(const Vec2* points, int count);

/// True when the points (3..8, either winding) are finite, convex and enclose some area.
bool isConvex(const Vec2* points, int count);

}  // namespace plumb::box_physics
