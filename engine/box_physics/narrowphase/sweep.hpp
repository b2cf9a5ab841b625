#pragma once

#include "box_physics/settings.hpp"
#include "box_physics/shape.hpp"

namespace plumb::box_physics {

/// A box or a circle on its way through one step, relative to what it may hit.
struct Mover {
    ShapeKind kind = ShapeKind::Box;
    Vec2 centre;         ///< m, at the start
    Vec2 half;           ///< m; the radius for a circle
    Vec2 path;           ///< m, over the step
    float slack = 0.0f;  ///< m that forces alone add to the path, and the ground will take away again
};

/// How well a touch speaks for itself: a corner that only exists because a tile ends there counts last.
enum class TouchRank : std::uint8_t { Face, Corner, InnerCorner };

/// Where a mover first touches something.
struct Touch {
    bool hit = false;
    TouchRank rank = TouchRank::Face;
    float time = 0.0f;        ///< part of the path, 0..1; 0 when they touch at the start
    float separation = 0.0f;  ///< m along the normal at the start; negative when they overlap
    Vec2 normal;              ///< length 1, from the other one towards the mover
};

Touch sweepToBox(const Mover& mover, Vec2 centre, Vec2 half, const Settings& settings);
Touch sweepToCircle(const Mover& mover, Vec2 centre, float radius, const Settings& settings);
Touch sweepToConvex(const Mover& mover, const Convex& convex, const Settings& settings);

/// A point on the mover's outline nearest to what it touches (m), for events and drawing.
Vec2 touchPoint(const Mover& mover, const Touch& touch);

}  // namespace plumb::box_physics
