#pragma once

#include <cstdint>
#include <span>

#include "physics/geometry.hpp"
#include "physics/lanes.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// A point at which two outlines touch or nearly touch.
struct ManifoldPoint {
    Vec2 point;               ///< m, in the frame of the first outline: midway between the two surfaces
    float separation = 0.0f;  ///< m along the normal; negative: overlap
    std::uint16_t id = 0;     ///< identifies the touching features: a point keeps its id between steps
};

/// The contact points of two outlines and their common normal.
struct Manifold {
    Vec2 normal;  ///< unit length, in the frame of the first outline, from the first to the second
    ManifoldPoint points[2];
    int count = 0;  ///< 0: the outlines are further apart than the limit
    /// m: radius of the outline's round feature at these points; 0 for a face or a sharp corner. A round
    /// feature can rotate about its centre without moving the contact point.
    float roundA = 0.0f;
    float roundB = 0.0f;
};

/// Computes the contact manifold of two outlines. Points with a separation above `speculative` (m) are
/// omitted. Two chain segments never collide.
/// @param corners  Shapes::corners
/// @param bInA     B's frame relative to A's
/// @return the manifold in A's frame
Manifold collide(const Geometry& a, const Geometry& b, std::span<const Corner> corners, const Frame& bInA,
                 float speculative);

/// Exchanges A and B in a manifold.
/// @param aInB  the frame of the former A relative to the former B
Manifold swapped(const Manifold& manifold, const Frame& aInB);

// The parts of collide().
/// Collides a circle with any convex outline.
Manifold collideCircleConvex(const Geometry& circle, const Geometry& other, std::span<const Corner> corners,
                             const Frame& bInA, float speculative);
/// Collides two convex outlines, neither of them a circle.
Manifold collideConvex(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                       const Frame& bInA, float speculative);
/// Collides any outline with a chain segment. The segment is solid on one side. Vertices shared with
/// neighbouring segments do not stop bodies that slide over them.
Manifold collideChain(const Geometry& a, const Geometry& chain, std::span<const Corner> corners,
                      const Frame& bInA, float speculative);

/// Eight pairs of boxes A and B. Each pair is in a frame with the centre and the axes of A.
/// @tparam Row  eight numbers: an array, or the SIMD type of the kernel
/// @tparam Pair  eight vectors: arrays, or the SIMD type of the kernel
template <class Row, class Pair>
struct BoxPairOf {
    Pair halfA, halfB;     // m
    Pair place;            // m: position of B's centre
    Row cosine, sine;      // B's rotation
    Row radiusA, radiusB;  // m
};

/// The manifolds of eight pairs of boxes.
template <class Row, class Pair>
struct BoxTouchOf {
    Pair normal;  // from A to B
    Pair point[2];
    Row separation[2];
    Row id[2];  // corner of A * 256 + corner of B; corners are 0 (-,-), 1 (+,-), 2 (-,+), 3 (+,+)
    Row count;
    Row roundA, roundB;
};

// Eight pairs of boxes, one per SIMD lane, and their contacts.
using BoxPairs = BoxPairOf<float[kLanes], VecLanes>;
using BoxTouches = BoxTouchOf<float[kLanes], VecLanes>;

void putPair(BoxPairs& pairs, int lane, const Geometry& a, const Geometry& b, const Frame& bInA);
/// @param a  the first box of the pair
[[nodiscard]] Manifold manifoldOf(const BoxTouches& touches, int lane, const Geometry& a);

}  // namespace plumb::physics
