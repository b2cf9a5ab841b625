#pragma once

#include <span>

#include "physics/model/geometry.hpp"
#include "physics/narrowphase/manifold.hpp"

namespace plumb::physics {

/// Computes the contact manifold of two outlines. Points with a separation above `speculative` (m) are
/// omitted. Two chain segments never collide.
/// @param corners  Shapes::corners
/// @param bInA     B's frame relative to A's
/// @return         in A's frame
Manifold collide(const Geometry& a, const Geometry& b, std::span<const Corner> corners, const Frame& bInA,
                 float speculative);

/// A manifold with A and B exchanged.
/// @param aInB  the frame of the former A relative to the former B
Manifold swapped(const Manifold& manifold, const Frame& aInB);

// The parts of collide().
/// A circle and any convex outline.
Manifold collideCircleConvex(const Geometry& circle, const Geometry& other, std::span<const Corner> corners,
                             const Frame& bInA, float speculative);
/// Any two convex outlines, neither of them a circle.
Manifold collideConvex(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                       const Frame& bInA, float speculative);
/// Any outline and a chain segment. The segment is solid on one side, and its joints with its neighbours are
/// smooth: they stop no body that slides over them.
Manifold collideChain(const Geometry& a, const Geometry& chain, std::span<const Corner> corners,
                      const Frame& bInA, float speculative);

}  // namespace plumb::physics
