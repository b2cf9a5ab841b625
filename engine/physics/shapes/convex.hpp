#pragma once

#include <array>
#include <span>

#include "physics/geometry.hpp"

namespace plumb::physics {

/// Any outline as one thing: the hull of its corners, grown by a radius. One corner is a disc; two are a
/// segment or a capsule, with a face on either side; more are a polygon. What works on all outlines alike
/// works on this. May be copied; valid as long as the pool that it was made from is not changed.
struct Convex {
    float radius = 0.0f;           ///< m
    Vec2 centre;                   ///< m, inside of it
    int count = 0;                 ///< of corners
    const Corner* pool = nullptr;  ///< where a polygon's corners are; all others have them in `own`
    std::array<Corner, 4> own;

    [[nodiscard]] std::span<const Corner> corners() const {
        return {pool != nullptr ? pool : own.data(), static_cast<std::size_t>(count)};
    }
};

/// A capsule shorter than this part of its radius is a disc: its direction means nothing.
inline constexpr float kShortestCapsule = 1.0e-5f;

/// The direction that is used where geometry has none to offer, as between two discs on one centre.
inline constexpr Vec2 kAnyNormal{1.0f, 0.0f};

/// @param pool  World::corners; only polygons look into it
Convex convexOf(const Geometry& geometry, std::span<const Corner> pool);

/// The two corners of a segment or the core of a capsule, each with the face that follows it.
std::array<Corner, 2> cornersOfSegment(Vec2 start, Vec2 end);
/// From the one towards (-, -) on in the sense in which normals turn, as all corners are ordered.
std::array<Corner, 4> cornersOfBox(Vec2 centre, Vec2 half, Rot turn);

/// The corner that is farthest along a direction; the first of equals.
int farthest(std::span<const Corner> corners, Vec2 direction);

/// A corner in another frame.
constexpr Corner apply(const Frame& frame, const Corner& corner) {
    return {apply(frame, corner.point), rotate(frame.rotation, corner.normal)};
}

}  // namespace plumb::physics
