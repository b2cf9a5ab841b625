#pragma once

#include <span>

#include "physics/geometry.hpp"
#include "physics/narrowphase/manifold.hpp"

namespace plumb::physics {

/// Where two outlines touch, or nearly do: points further apart than `speculative` (m) are left out.
/// @param corners  World::corners
/// @param bInA     B's frame seen from A's
/// @return         in A's frame
using Collide = Manifold (*)(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                             const Frame& bInA, float speculative);

/// The function for two kinds of outlines; two chains never touch.
Collide collideOf(ShapeKind a, ShapeKind b);

inline Manifold collide(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                        const Frame& bInA, float speculative) {
    return collideOf(a.kind, b.kind)(a, b, corners, bInA, speculative);
}

/// A manifold with its sides exchanged.
/// @param aInB  the frame that the points were in, seen from the new first side
Manifold swapped(const Manifold& manifold, const Frame& aInB);

// The functions behind the table. B's kind is that of the name's second part, or a later one.
Manifold collideCircles(const Geometry& a, const Geometry& b, std::span<const Corner>, const Frame& bInA,
                        float speculative);
Manifold collideCircleBox(const Geometry& circle, const Geometry& box, std::span<const Corner>,
                          const Frame& bInA, float speculative);
/// A circle and any convex outline.
Manifold collideCircleConvex(const Geometry& circle, const Geometry& other, std::span<const Corner> corners,
                             const Frame& bInA, float speculative);
Manifold collideBoxes(const Geometry& a, const Geometry& b, std::span<const Corner>, const Frame& bInA,
                      float speculative);
/// Any two convex outlines, neither a circle.
Manifold collideConvex(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                       const Frame& bInA, float speculative);
/// Anything and a chain segment, which is solid on one side and whose joints with its neighbours are not
/// felt.
Manifold collideChain(const Geometry& a, const Geometry& chain, std::span<const Corner> corners,
                      const Frame& bInA, float speculative);

}  // namespace plumb::physics
