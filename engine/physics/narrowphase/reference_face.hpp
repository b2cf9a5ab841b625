#pragma once

#include <optional>
#include <span>

#include "physics/narrowphase/collide.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// One of two colliding outlines, in the frame of the first: a convex core, enlarged by a radius.
struct Side {
    std::span<const Corner> corners;
    float radius = 0.0f;  ///< m
    Vec2 centre;          ///< m
};

inline Side sideOf(const Convex& convex) { return {convex.corners(), convex.radius, convex.centre}; }

/// The corners of a convex outline, transformed to another frame.
struct MovedCorners {
    CornerRoom room;

    Side moved(const Convex& convex, const Frame& frame) {
        std::size_t count = 0;
        for (const Corner& corner : convex.corners()) room.corners[count++] = apply(frame, corner);
        return {{room.corners, count}, convex.radius, apply(frame, convex.centre)};
    }
};

/// The face with the maximum separation from another core, and that separation.
struct FaceGap {
    std::size_t face = 0;
    float gap = 0.0f;  ///< m; negative: overlap
};

FaceGap widestGap(std::span<const Corner> faces, std::span<const Corner> other);
/// The face whose normal is most opposed to a direction.
std::size_t faceAgainst(std::span<const Corner> faces, Vec2 direction);

/// m: the second outline provides the reference face only if its separation is larger by this.
inline float faceTieOf(float halfSize) { return std::min(kMaxFaceTie, kFaceTie * halfSize); }

/// The incident edge in the coordinates of the reference edge: along it and in front of it.
struct EdgeOnEdge {
    Vec2 origin;   ///< start of the reference edge
    Vec2 normal;   ///< of the reference edge, outward
    Vec2 tangent;  ///< from its start to its end
    float length = 0.0f;
    std::size_t face = 0;   ///< index of the reference edge
    std::size_t start = 0;  ///< corners of the incident edge: at the lower position on the tangent,
    std::size_t end = 0;    ///< and at the higher one
    Vec2 low, high;         ///< x along the tangent, y in front of the edge
};

EdgeOnEdge edgeOnEdge(const Side& reference, std::size_t face, const Side& other);

/// Two separated cores that are nearest at a corner of each, not at a face.
struct CornerPair {
    std::size_t reference = 0;
    std::size_t other = 0;
    Vec2 displacement;  ///< from the corner of the reference to the other one
    float distance = 0.0f;
};

std::optional<CornerPair> nearestCorners(const EdgeOnEdge& edges, const Side& reference, const Side& other);

/// Collects the points of a manifold whose separation is within the limit.
struct ManifoldMaker {
    Manifold manifold;
    float speculative = 0.0f;

    /// @return  true if the point was added; not for NaN
    bool add(Vec2 point, float separation, std::size_t cornerA, std::size_t cornerB) {
        if (!(separation <= speculative)) return false;
        manifold.points[manifold.count++] = {point, separation,
                                             static_cast<std::uint16_t>(cornerA << 8 | cornerB)};
        return true;
    }
};

/// Clips the incident edge to the part in front of the reference edge.
/// @param isB  the reference is the second side
Manifold touchEdge(const EdgeOnEdge& edges, const Side& reference, const Side& other, bool isB,
                   float speculative);

/// The points of another side in front of a given face of the first: their normal is that of the face.
/// @param beyond  m: by how much the face is longer at its start and at its end
Manifold touchFace(const Side& a, std::size_t face, const Side& b, float speculative, Vec2 beyond);

}  // namespace plumb::physics
