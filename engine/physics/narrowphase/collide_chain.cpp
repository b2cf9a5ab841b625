#include "physics/narrowphase/reference_face.hpp"

namespace plumb::physics {

namespace {

/// True if the chain is convex at a vertex where its normal changes from `from` to `to`.
bool isSharp(Vec2 from, Vec2 to) { return cross(from, to) > (dot(from, to) > 0.0f ? kParallel : 0.0f); }

/// A vertex of a chain. At a convex vertex, contact normals between those of its two segments are valid. To
/// avoid duplicates, the segment that starts at a vertex handles it; the last segment also handles its end.
struct ChainJoint {
    Vec2 point;
    Vec2 from, to;       ///< normals of both segments, in the direction of rotation
    Vec2 neighbour;      ///< far end of the other segment; `point` if there is none
    bool sharp = false;  ///< true at a convex vertex
    bool ours = true;    ///< true if this segment handles the vertex

    [[nodiscard]] bool allows(Vec2 direction) const {
        return sharp && cross(from, direction) >= 0.0f && cross(direction, to) >= 0.0f;
    }
};

/// A chain segment in the frame of the other outline. Its Side has a front face and a back face.
struct Chain {
    Corner corners[2];
    ChainJoint joints[2];  ///< at the start, at the end

    [[nodiscard]] Side side() const { return {corners, 0.0f, corners[0].point}; }
    [[nodiscard]] Vec2 normal() const { return corners[0].normal; }
};

Vec2 normalBetween(Vec2 from, Vec2 to) { return normalized(Vec2{to.y - from.y, from.x - to.x}); }

Chain chainIn(const Geometry& geometry, const Frame& frame) {
    const Vec2 before = apply(frame, beforeOf(geometry));
    const Vec2 start = apply(frame, geometry.a);
    const Vec2 end = apply(frame, geometry.b);
    const Vec2 after = apply(frame, geometry.after);
    const Vec2 normal = normalBetween(start, end);
    const bool starts = beforeOf(geometry) == geometry.a;
    const bool ends = geometry.after == geometry.b;
    // At a free end: the perpendicular.
    const Vec2 from = starts ? -perpendicular(normal) : normalBetween(before, start);
    const Vec2 to = ends ? perpendicular(normal) : normalBetween(end, after);
    return {{{start, normal}, {end, -normal}},
            {{start, from, normal, before, isSharp(from, normal), true},
             {end, normal, to, after, isSharp(normal, to), ends}}};
}

/// Returns the contact of a vertex of the chain with a face or a corner of the other side.
Manifold touchJoint(const ChainJoint& joint, std::size_t end, Vec2 direction, float gap, float radius,
                    std::size_t corner, float speculative) {
    if (!joint.ours) return {};
    ManifoldMaker maker{.speculative = speculative};
    const float separation = gap - radius;
    maker.add(joint.point + direction * (0.5f * separation), separation, corner, end);
    maker.manifold.normal = -direction;
    return maker.manifold;
}

/// The maximum separation of a vertex of the chain along a face normal of the other side.
struct JointGap {
    float gap = -1.0e30f;
    std::size_t face = 0;
    std::size_t end = 0;
};

JointGap widestJointGap(const Chain& chain, const Side& other) {
    JointGap widest;
    for (std::size_t face = 0; face < other.corners.size(); ++face) {
        const Corner& corner = other.corners[face];
        for (std::size_t end = 0; end < 2; ++end) {
            if (!chain.joints[end].allows(-corner.normal)) continue;
            const float gap = dot(corner.normal, chain.joints[end].point - corner.point);
            if (gap > widest.gap) widest = {gap, face, end};
        }
    }
    return widest;
}

/// Returns the contact of a chain vertex with a corner, if the direction is between the vertex's normals.
Manifold touchCorner(const Chain& chain, const Side& other, std::size_t end, std::size_t corner,
                     Vec2 displacement, float speculative) {
    const float distance = length(displacement);
    const Vec2 direction = displacement / distance;
    if (!chain.joints[end].allows(direction)) return {};
    Manifold manifold =
        touchJoint(chain.joints[end], end, direction, distance, other.radius, corner, speculative);
    manifold.roundA = manifold.count > 0 ? other.radius : 0.0f;
    return manifold;
}

/// Returns the contact of a face of the other side with a chain vertex.
Manifold touchFaceOnJoint(const Chain& chain, const Side& other, const JointGap& joint, float speculative) {
    const Corner& face = other.corners[joint.face];
    const std::size_t next = joint.face + 1 < other.corners.size() ? joint.face + 1 : 0;
    const Vec2 point = chain.joints[joint.end].point;
    const Vec2 tangent = perpendicular(face.normal);
    const float along = dot(point - face.point, tangent);
    const bool before = along < 0.0f;
    if (!before && along <= dot(other.corners[next].point - face.point, tangent)) {
        return touchJoint(chain.joints[joint.end], joint.end, -face.normal, joint.gap, other.radius,
                          joint.face, speculative);
    }
    if (!(joint.gap > 0.0f)) return {};
    const std::size_t corner = before ? joint.face : next;
    return touchCorner(chain, other, joint.end, corner, other.corners[corner].point - point, speculative);
}

/// Returns the contact with the vertex shared with a neighbour, if it is the neighbour's nearest point.
Manifold touchBeside(const Chain& chain, const Side& other, std::size_t end, float speculative) {
    const ChainJoint& joint = chain.joints[end];
    if (!joint.ours || !joint.sharp) return {};
    const Vec2 normal = end == 0 ? joint.from : joint.to;
    const Vec2 start = end == 0 ? joint.neighbour : joint.point;
    const Corner corners[2] = {{start, normal}, {end == 0 ? joint.point : joint.neighbour, -normal}};
    const Side neighbour{corners, 0.0f, joint.point};
    const auto pair = nearestCorners(edgeOnEdge(neighbour, 0, other), neighbour, other);
    if (!pair || !(corners[pair->reference].point == joint.point)) return {};
    return touchCorner(chain, other, end, pair->other, pair->displacement, speculative);
}

/// Returns the contact with the front face of the chain segment.
Manifold touchFace(const Chain& chain, const Side& other, float gap, float speculative) {
    const EdgeOnEdge edges = edgeOnEdge(chain.side(), 0, other);
    if (gap > 0.0f) {
        if (const auto pair = nearestCorners(edges, chain.side(), other))
            return touchCorner(chain, other, pair->reference, pair->other, pair->displacement, speculative);
    }
    // Beyond an end the contact belongs to the neighbour, unless the shared vertex is nearest.
    const bool before = edges.high.x < 0.0f;
    if (before || edges.low.x > edges.length) return touchBeside(chain, other, before ? 0 : 1, speculative);
    return touchEdge(edges, chain.side(), other, true, speculative);
}

/// Returns the largest separation of `other` from the lines through those neighbouring segments that meet
/// this one at a convex vertex.
JointGap widestNeighbourGap(const Chain& chain, const Side& other) {
    JointGap widest;
    for (std::size_t end = 0; end < 2; ++end) {
        const ChainJoint& joint = chain.joints[end];
        if (!joint.sharp) continue;
        const Corner face{joint.point, end == 0 ? joint.from : joint.to};
        const float gap = widestGap({&face, 1}, other.corners).gap;
        if (gap > widest.gap) widest = {gap, 0, end};
    }
    return widest;
}

Manifold touchDisc(const Chain& chain, const Side& disc, bool inFront, float gap, float speculative) {
    const Vec2 centre = disc.corners[0].point;
    const Vec2 tangent = perpendicular(chain.normal());
    const float along = dot(centre - chain.corners[0].point, tangent);
    const bool before = along < 0.0f;
    if (before || along > dot(chain.corners[1].point - chain.corners[0].point, tangent)) {
        const std::size_t end = before ? 0 : 1;
        return touchCorner(chain, disc, end, 0, centre - chain.corners[end].point, speculative);
    }
    ManifoldMaker maker{.speculative = speculative};
    const float separation = gap - disc.radius;
    if (inFront) maker.add(centre - chain.normal() * (disc.radius + 0.5f * separation), separation, 0, 0);
    maker.manifold.normal = -chain.normal();
    maker.manifold.roundA = disc.radius;
    return maker.manifold;
}

}  // namespace

Manifold collideChain(const Geometry& a, const Geometry& b, std::span<const Corner> corners,
                      const Frame& bInA, float speculative) {
    const Convex convex = convexOf(a, corners);
    const Side other = sideOf(convex);
    const Chain chain = chainIn(b, bInA);
    const float gap = widestGap({chain.corners, 1}, other.corners).gap;
    const float reach = speculative + other.radius;
    if (!(gap <= reach)) return {};

    const auto isBefore = [&](Vec2 normal, Vec2 point) { return dot(normal, other.centre - point) >= 0.0f; };
    const bool inFront = isBefore(chain.normal(), chain.corners[0].point);
    if (convex.count == 1) return touchDisc(chain, other, inFront, gap, speculative);
    // An outline in front of only the neighbour can still touch this segment at a convex vertex.
    const auto isAround = [&](const ChainJoint& side, Vec2 normal) {
        return side.sharp && isBefore(normal, side.point);
    };
    const ChainJoint& start = chain.joints[0];
    const ChainJoint& end = chain.joints[1];
    if (!inFront && !isAround(start, start.from) && !isAround(end, end.to)) return {};

    const JointGap joint = widestJointGap(chain, other);
    const JointGap beside = widestNeighbourGap(chain, other);
    if (joint.gap > reach || beside.gap > reach) return {};
    const float tie = faceTieOf(distance(chain.corners[0].point, chain.corners[1].point));
    const bool byFace = gap + tie >= joint.gap;
    if (beside.gap > (byFace ? gap + tie : joint.gap))
        return touchBeside(chain, other, beside.end, speculative);
    if (!inFront && (byFace ? gap : joint.gap) < -speculative) return {};  // from the back: not solid
    if (byFace) return touchFace(chain, other, gap, speculative);
    return touchFaceOnJoint(chain, other, joint, speculative);
}

}  // namespace plumb::physics
