#pragma once

#include <array>
#include <span>

#include "physics/geometry.hpp"

namespace plumb::physics {

/// Any outline in a common form: the convex hull of its corners, enlarged by a radius. One corner is a disc;
/// two are a segment or a capsule, with two faces; more are a polygon. Valid until the pool changes.
struct Convex {
    float radius = 0.0f;           ///< m
    Vec2 centre;                   ///< m, a point inside
    int count = 0;                 ///< number of corners
    const Corner* pool = nullptr;  ///< corners of a polygon; other outlines use `own`
    std::array<Corner, 4> own;

    [[nodiscard]] std::span<const Corner> corners() const {
        return {pool != nullptr ? pool : own.data(), static_cast<std::size_t>(count)};
    }
};

/// Memory for the corners of any outline, not initialized to save time.
union CornerRoom {
    CornerRoom() {}
    Corner corners[kMaxCorners];
};

class ScaledConvex {
public:
    ScaledConvex(const Convex& outline, Vec2 about, float part);  ///< scaled by `part` about a point
    ScaledConvex(const ScaledConvex&) = delete;
    ScaledConvex& operator=(const ScaledConvex&) = delete;

    [[nodiscard]] const Convex& outline() const { return convex_; }

private:
    Convex convex_;
    CornerRoom room_;
};

/// The normal that is used if the geometry defines none, as for two discs with the same centre.
inline constexpr Vec2 kAnyNormal{1.0f, 0.0f};

/// @param pool  Shapes::corners; used for polygons only
Convex convexOf(const Geometry& geometry, std::span<const Corner> pool);

/// Returns the corners of a box from (-, -) on, in the direction of rotation from x to y like all outlines.
std::array<Corner, 4> cornersOfBox(Vec2 centre, Vec2 half, Rot rotation);

/// Support function: returns the index of the corner farthest along a direction; the first of equal ones.
int farthest(std::span<const Corner> corners, Vec2 direction);
/// Returns the extent (m) of an outline along a direction of unit length, from the origin of its frame.
float reachAlong(const Convex& outline, Vec2 direction);

/// Index of a corner and the value for which largestOf() selected it.
struct BestCorner {
    std::size_t index = 0;
    float value = 0.0f;
};
/// Returns the corner with the largest valueOf(corner); the first of equal ones.
template <class ValueOf>
BestCorner largestOf(std::span<const Corner> corners, ValueOf&& valueOf) {
    BestCorner best{0, valueOf(corners[0])};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const float value = valueOf(corners[i]);
        if (value > best.value) best = {i, value};
    }
    return best;
}

constexpr Corner apply(const Frame& frame, const Corner& corner) {
    return {apply(frame, corner.point), rotate(frame.rotation, corner.normal)};
}

}  // namespace plumb::physics
