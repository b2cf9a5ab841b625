#pragma once

#include <optional>
#include <span>

#include "physics/narrowphase/manifold.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// One of two outlines that collide, in the frame of the first: a convex core, grown by a radius.
struct Side {
    std::span<const Corner> corners;
    float radius = 0.0f;  ///< m
    Vec2 centre;          ///< m
};

inline Side sideOf(const Convex& convex) { return {convex.corners(), convex.radius, convex.centre}; }

/// The corners of a convex outline in another frame.
struct MovedCorners {
    Corner corners[kMaxCorners];

    Side moved(const Convex& convex, const Frame& frame) {
        std::size_t count = 0;
        for (const Corner& corner : convex.corners()) corners[count++] = apply(frame, corner);
        return {{corners, count}, convex.radius, apply(frame, convex.centre)};
    }
};

/// How far another core is in front of a face; of all faces, the one where this is most.
struct FaceGap {
    std::size_t face = 0;
    float gap = 0.0f;  ///< m; negative when the cores overlap
};

FaceGap widestGap(std::span<const Corner> faces, std::span<const Corner> other);
/// The face that looks most against a direction.
std::size_t faceAgainst(std::span<const Corner> faces, Vec2 direction);

/// m: a second face must be better by this much to be taken, so that normals do not flicker between faces
/// that are nearly parallel. A thousandth of the half size, that tiny shapes are not mistaken, and at most
/// 0.5 mm.
inline float tieOf(float halfSize) { return 0.001f * halfSize < 0.0005f ? 0.001f * halfSize : 0.0005f; }

/// An edge of the one side seen from an edge of the other: along it and in front of it.
struct EdgeOnEdge {
    Vec2 origin;   ///< start of the reference edge
    Vec2 normal;   ///< of the reference edge, outward
    Vec2 tangent;  ///< from its start to its end
    float length = 0.0f;
    std::size_t face = 0;   ///< of the reference side
    std::size_t start = 0;  ///< corners of the other edge: at the lower place along the tangent,
    std::size_t end = 0;    ///< and at the higher
    Vec2 low, high;         ///< x along the tangent, y in front of the edge
};

EdgeOnEdge edgeOnEdge(const Side& reference, std::size_t face, const Side& other);

/// Where two cores that are apart come nearest with a corner of each, not with a face.
struct CornerPair {
    std::size_t reference = 0;
    std::size_t other = 0;
    Vec2 way;  ///< from the reference's corner to the other's
    float distance = 0.0f;
};

std::optional<CornerPair> nearestCorners(const EdgeOnEdge& edges, const Side& reference, const Side& other);

/// Collects the points of a manifold that are near enough.
struct ManifoldMaker {
    Manifold manifold;
    float speculative = 0.0f;

    /// @return  whether it was near enough; NaN is not
    bool add(Vec2 point, float separation, std::size_t cornerA, std::size_t cornerB) {
        if (!(separation <= speculative)) return false;
        manifold.points[manifold.count++] = {point, separation,
                                             static_cast<std::uint16_t>(cornerA << 8 | cornerB)};
        return true;
    }
};

/// The part of the other edge that lies in front of the reference edge.
/// @param isB  the reference is the second side
Manifold touchEdge(const EdgeOnEdge& edges, const Side& reference, const Side& other, bool isB,
                   float speculative);

/// Any two convex sides of two corners or more.
/// Source: separating axes after C. Ericson, "Real-Time Collision Detection", 2005, 4.4; clipping of edges
/// after
///         E. Catto, "Contact Manifolds", GDC 2007
Manifold collideSides(const Side& a, const Side& b, float speculative);

}  // namespace plumb::physics
