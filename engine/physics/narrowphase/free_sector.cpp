#include "physics/narrowphase/free_sector.hpp"

#include <cmath>

#include "physics/shapes/shape_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// How a point is to an outline, and the normals of the first and the last edge at it, in the order of
/// rotation.
struct Edges {
    Vec2 first, last;
    bool isAt = false;
    bool isInside = false;
};

Edges edgesAt(const Convex& outline, Vec2 point, float tolerance) {
    Edges edges;
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

}  // namespace

/// Grows with the angle from 0 to 4, each quarter by 1.
float FreeSector::angleFrom(Vec2 direction) const {
    const float along = dot(inside_, direction), across = cross(inside_, direction);
    const float part = along / (std::fabs(along) + std::fabs(across));
    return across >= 0.0f ? 1.0f - part : 3.0f + part;
}

bool FreeSector::cover(const Convex& outline, const Frame& frame) {
    const Vec2 place = applyInverse(frame, point_);
    const Edges edges = edgesAt(outline, place, tolerance_);
    if (!edges.isAt) return false;
    const Vec2 first = rotate(frame.rotation, edges.first), last = rotate(frame.rotation, edges.last);
    const Border start{angleFrom(-perpendicular(first)), first}, end{angleFrom(perpendicular(last)), last};
    isCovered_ = isCovered_ || edges.isInside || end.angle > start.angle;
    if (start.angle > start_.angle) start_ = start;
    if (end.angle < end_.angle) end_ = end;
    if (!ownStart_) {
        ownStart_ = start;
        ownEnd_ = end;
    }
    return true;
}

bool FreeSector::isClosed() const { return isCovered_ || end_.angle + 4.0f - start_.angle < kParallel; }

bool FreeSector::isFlat() const { return dot(start_.normal, end_.normal) > 1.0f - kSameNormal; }

bool FreeSector::allows(Vec2 normal) const {
    // All normals between two are within half of their angle from their middle.
    const Vec2 middle = normalized(start_.normal + end_.normal);
    return dot(normal, middle) >= dot(start_.normal, middle) - kSameNormal;
}

std::optional<Vec2> FreeSector::ownNormal(Vec2 normal) const {
    const bool starts = ownStart_->angle > start_.angle - kParallel;
    const bool ends = ownEnd_->angle < end_.angle + kParallel;
    if (!starts && !ends) return std::nullopt;
    if (!ends) return ownStart_->normal;
    if (!starts) return ownEnd_->normal;
    return dot(ownStart_->normal, normal) > dot(ownEnd_->normal, normal) ? ownStart_->normal
                                                                         : ownEnd_->normal;
}

}  // namespace plumb::physics
