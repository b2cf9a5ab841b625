#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Queries see the world as it is between two steps, including changes since the last step, and never affect
// the result of the next one. They update the broad phase first and use the world's scratch memory, so only
// one query may run at a time.

struct QueryFilter {
    std::uint32_t layers = 0xffffffffu;  ///< bits: layers of the query; a shape's mask must have one of them
    std::uint32_t mask = 0xffffffffu;    ///< bits: layers that the query considers
    bool triggers = false;               ///< include triggers
    bool movers = true;                  ///< include shapes of dynamic and kinematic bodies
    bool fixed = true;                   ///< include shapes of static bodies
    BodyId except{};                     ///< ignore the shapes of this body
};

/// An outline in the world, for a query.
struct QueryShape {
    Geometry geometry{};
    WorldPosition position{};  ///< m, of the frame that the geometry is defined in
    Rot rotation{};
    std::span<const Corner> corners = {};  ///< of a polygon, by Geometry::first; if empty, Shapes::corners
};

struct CastHit {
    ShapeId shape;
    BodyId body;
    WorldPosition point;    ///< m, on the shape's surface
    Vec2 normal;            ///< unit length, outward from the shape
    float fraction = 0.0f;  ///< fraction of the displacement, 0..1; 0 if it started inside
    float distance = 0.0f;  ///< m travelled
    /// m between both at the start, for a moving outline; negative: penetration depth along the normal
    float separation = 0.0f;
};

}  // namespace plumb::physics
