#pragma once

#include <cmath>
#include <optional>

#include "physics/shapes/shape_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// How a point is to an outline, and the normals of the first and the last edge at it, in the order of
/// rotation.
struct EdgesAt {
    Vec2 first, last;
    bool isAt = false;
    bool isInside = false;
};

inline EdgesAt edgesAt(const Convex& outline, Vec2 point, float tolerance) {
    EdgesAt edges;
    if (outline.radius > 0.0f) {
        const ClosestPoint closest = closestPointOf(outline, point);
        return {closest.normal, closest.normal, closest.distance <= tolerance, closest.distance < -tolerance};
    }
    const std::span<const Corner> corners = outline.corners();
    const auto heightOver = [&](const Corner& face) { return dot(face.normal, point - face.point); };
    bool before = heightOver(corners.back()) >= -tolerance;
    edges.isInside = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const float height = heightOver(corners[i]);
        if (!(height <= tolerance)) return {};
        const bool is = height >= -tolerance;
        if (is) edges.isInside = false;
        if (is && !before) edges.first = corners[i].normal;
        if (!is && before) edges.last = corners[i > 0 ? i - 1 : corners.size() - 1].normal;
        before = is;
    }
    edges.isAt = edges.isInside || edges.first != Vec2{};  // else it is smaller than the tolerance
    return edges;
}

/// The directions from a point that the outlines around it leave free. Outlines that abut have one border,
/// and only its normals are those of contacts there: not those of the edges between them.
class FreeSector {
public:
    /// @param inside     a free direction: to the middle of what touches the outlines at the point
    /// @param tolerance  m: outlines closer than this to the point cover a part of its surroundings
    FreeSector(Vec2 point, Vec2 inside, float tolerance)
        : point_{point}, inside_{inside}, tolerance_{tolerance} {}

    /// Takes away what an outline covers: first the one that the contact is with, then its neighbors.
    /// @return  false if it is not at the point
    bool cover(const Convex& outline, const Frame& frame) {
        const Vec2 place = applyInverse(frame, point_);
        const EdgesAt edges = edgesAt(outline, place, tolerance_);
        if (!edges.isAt) return false;
        const Vec2 first = rotate(frame.rotation, edges.first), last = rotate(frame.rotation, edges.last);
        const Border start{angleFrom(-perpendicular(first)), first},
            end{angleFrom(perpendicular(last)), last};
        isCovered_ = isCovered_ || edges.isInside || end.angle > start.angle;
        if (start.angle > start_.angle) start_ = start;
        if (end.angle < end_.angle) end_ = end;
        if (!ownStart_) {
            ownStart_ = start;
            ownEnd_ = end;
        }
        return true;
    }

    /// True where the outlines surround the point, or cover `inside`.
    [[nodiscard]] bool isClosed() const { return isCovered_ || end_.angle + 4.0f - start_.angle < kParallel; }
    /// True where the common border is straight.
    [[nodiscard]] bool isFlat() const { return dot(start_.normal, end_.normal) > 1.0f - kSameNormal; }
    /// True for a normal of the common border, or one between its two normals at a corner.
    [[nodiscard]] bool allows(Vec2 normal) const {
        // All normals between two are within half of their angle from their middle.
        const Vec2 middle = normalized(start_.normal + end_.normal);
        return dot(normal, middle) >= dot(start_.normal, middle) - kSameNormal;
    }
    /// The normal of the first outline at the border that is nearest to the given one, if it has a part of
    /// it.
    [[nodiscard]] std::optional<Vec2> ownNormal(Vec2 normal) const {
        const bool starts = ownStart_->angle > start_.angle - kParallel;
        const bool ends = ownEnd_->angle < end_.angle + kParallel;
        if (!starts && !ends) return std::nullopt;
        if (!ends) return ownStart_->normal;
        if (!starts) return ownEnd_->normal;
        return dot(ownStart_->normal, normal) > dot(ownEnd_->normal, normal) ? ownStart_->normal
                                                                             : ownEnd_->normal;
    }

private:
    /// A border of a covered sector.
    struct Border {
        float angle;  ///< from `inside`, counterclockwise, see angleFrom()
        Vec2 normal;  ///< outward
    };
    /// Grows with the angle from 0 to 4, each quarter by 1.
    [[nodiscard]] float angleFrom(Vec2 direction) const {
        const float along = dot(inside_, direction), across = cross(inside_, direction);
        const float part = along / (std::fabs(along) + std::fabs(across));
        return across >= 0.0f ? 1.0f - part : 3.0f + part;
    }

    Vec2 point_;
    Vec2 inside_;
    float tolerance_;
    bool isCovered_ = false;  ///< `inside` is
    Border end_{4.0f, {}};    ///< of the free sector, and its other one: the borders of the nearest outlines
    Border start_{-1.0f, {}};
    std::optional<Border> ownEnd_, ownStart_;
};

}  // namespace plumb::physics
