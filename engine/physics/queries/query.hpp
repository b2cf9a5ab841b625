#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/world.hpp"

namespace plumb::physics {

// Questions about where things are. They see the world as it is now, between two steps, changes since the
// last step included, and never change what the next one does. They bring the broad phase up to date first
// and use the world's working memory: one question at a time.

/// Whom a query looks at.
struct QueryFilter {
    std::uint32_t layers = 0xffffffffu;  ///< bits: what the query is; a shape's mask must have one of them
    std::uint32_t mask = 0xffffffffu;    ///< bits: layers that it looks for
    bool triggers = false;               ///< triggers are found too
    bool movers = true;                  ///< shapes of dynamic and kinematic bodies are found
    bool fixed = true;                   ///< shapes of static bodies are found
    BodyId except{};                     ///< nothing of this body is found
};

/// An outline somewhere in the world, for a query.
struct QueryShape {
    Geometry geometry{};
    Place position{};  ///< m, of the frame that it is written in
    Rot rotation{};
    std::span<const Corner> corners = {};  ///< of a polygon, by Geometry::first; else World::corners
};

/// What a ray or a moving outline met.
struct CastHit {
    ShapeId shape;
    BodyId body;
    Place point;            ///< m, on the shape's surface
    Vec2 normal;            ///< length 1, out of the shape
    float fraction = 0.0f;  ///< ratio of the way, 0..1; 0 when it began inside
    float distance = 0.0f;  ///< m of the way
    /// m between both at the start, of a moving outline; negative: how deep they overlapped, along the normal
    float separation = 0.0f;
};

}  // namespace plumb::physics
