#pragma once

#include <optional>
#include <span>

#include "physics/narrowphase/collide.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// One of two colliding outlines, in the frame of the first outline: a convex core, enlarged by a radius.
struct Side {
    std::span<const Corner> corners;
    float radius = 0.0f;  ///< m
    Vec2 centre;          ///< m
};

inline Side sideOf(const Convex& convex) { return {convex.corners(), convex.radius, convex.centre}; }

/// Memory for the corners of a convex outline that are transformed to another frame.
struct MovedCorners {
    CornerRoom room;

    Side moved(const Convex& convex, const Frame& frame) {
        std::size_t count = 0;
        for (const Corner& corner : convex.corners()) room.corners[count++] = apply(frame, corner);
        return {{room.corners, count}, convex.radius, apply(frame, convex.centre)};
    }
};

/// The face of a core with the maximum separation from another core, and this separation.
struct FaceGap {
    std::size_t face = 0;
    float gap = 0.0f;  ///< m; negative: overlap
};

FaceGap widestGap(std::span<const Corner> faces, std::span<const Corner> other);
/// Returns the face whose normal is most opposed to a direction.
inline std::size_t faceAgainst(std::span<const Corner> faces, Vec2 direction) {
    return largestOf(faces, [&](const Corner& face) { return -dot(face.normal, direction); }).index;
}

/// A face of the second outline becomes the reference face only if its separation is larger by this (m).
inline float faceTieOf(float halfSize) { return std::min(kMaxFaceTie, kFaceTie * halfSize); }

/// The incident edge in coordinates along the reference edge and in front of it.
struct EdgeOnEdge {
    Vec2 origin;   ///< start of the reference edge
    Vec2 normal;   ///< outward normal of the reference edge
    Vec2 tangent;  ///< from its start to its end
    float length = 0.0f;
    std::size_t face = 0;   ///< index of the reference edge
    std::size_t start = 0;  ///< corner of the incident edge with the lower position on the tangent
    std::size_t end = 0;    ///< corner of the incident edge with the higher position
    Vec2 low, high;         ///< start and end: x along the tangent, y in front of the edge
};

EdgeOnEdge edgeOnEdge(const Side& reference, std::size_t face, const Side& other);

/// The nearest corners of two separated cores that are nearest at corners, not at a face.
struct CornerPair {
    std::size_t reference = 0;
    std::size_t other = 0;
    Vec2 displacement;  ///< m, from the corner of the reference to the other corner
    float distance = 0.0f;
};

std::optional<CornerPair> nearestCorners(const EdgeOnEdge& edges, const Side& reference, const Side& other);

/// Builds a manifold from the points whose separation is within `speculative` (m).
struct ManifoldMaker {
    Manifold manifold;
    float speculative = 0.0f;

    /// @return true if the point was added; false also for a separation of NaN
    bool add(Vec2 point, float separation, std::size_t cornerA, std::size_t cornerB) {
        if (!(separation <= speculative)) return false;
        manifold.points[manifold.count++] = {point, separation,
                                             static_cast<std::uint16_t>(cornerA << 8 | cornerB)};
        return true;
    }
};

/// Clips the incident edge to the part in front of the reference edge; returns the contact points.
/// @param isB  true if the reference face is of outline B
Manifold touchEdge(const EdgeOnEdge& edges, const Side& reference, const Side& other, bool isB,
                   float speculative);

/// Returns the contact points of `b` in front of a given face of `a`, with the normal of the face.
/// @param beyond  m: extension of the face at its start and its end
Manifold touchFace(const Side& a, std::size_t face, const Side& b, float speculative, Vec2 beyond);

}  // namespace plumb::physics
