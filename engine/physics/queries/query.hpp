#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

// Queries use the current state of the world, including changes since the last step, and never affect the
// result of the next step. They use scratch memory of the world, so only one query may run at a time.

struct QueryFilter {
    std::uint32_t layers = 0xffffffffu;  ///< bits: layers of the query; masks of shapes must include one
    std::uint32_t mask = 0xffffffffu;    ///< bits: layers of the shapes to find
    bool triggers = false;               ///< include triggers
    bool movers = true;                  ///< include shapes of dynamic and kinematic bodies
    bool fixed = true;                   ///< include shapes of static bodies
    BodyId except{};                     ///< ignore the shapes of this body
};

/// An outline in the world, for a query.
struct QueryShape {
    Geometry geometry{};
    WorldPosition position{};  ///< m: origin of the frame in which `geometry` is defined
    Rot rotation{};
    std::span<const Corner> corners = {};  ///< corners of a polygon; if empty, Shapes::corners
};

struct CastHit {
    ShapeId shape;
    BodyId body;
    WorldPosition point;    ///< m, on the shape's surface
    Vec2 normal;            ///< unit length, outward from the shape
    float fraction = 0.0f;  ///< fraction of the displacement, 0..1; 0 if it started inside
    float distance = 0.0f;  ///< m: distance travelled before the hit
    /// m: distance at the start, for a moving outline; negative: penetration depth along the normal
    float separation = 0.0f;
};

}  // namespace plumb::physics
