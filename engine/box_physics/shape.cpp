#include "box_physics/shape.hpp"

#include <algorithm>

namespace plumb::box_physics {

namespace {

float signedArea(const Vec2* points, int count) {
    float twice = 0.0f;
    for (int i = 0; i < count; ++i) {
        twice += cross(points[i], points[i + 1 == count ? 0 : i + 1]);
    }
    return twice * 0.5f;
}

}  // namespace

Convex convexFrom(const Vec2* points, int count) {
    Convex convex;
    convex.count = count;
    std::copy_n(points, count, convex.points.begin());
    if (signedArea(points, count) < 0.0f) std::reverse(convex.points.begin(), convex.points.begin() + count);
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Vec2 edge = convex.points[static_cast<std::size_t>(convex.next(i))] - convex.points[at];
        convex.normals[at] = normalized(Vec2{edge.y, -edge.x});
    }
    return convex;
}

bool isConvex(const Vec2* points, int count) {
    if (count < 3 || count > Convex::kMaxPoints) return false;
    const float area = signedArea(points, count);
    if (!(area * area > 1e-12f)) return false;
    for (int i = 0; i < count; ++i) {
        const Vec2 a = points[i];
        const Vec2 b = points[(i + 1) % count];
        const Vec2 c = points[(i + 2) % count];
        if (!isFinite(a) || cross(b - a, c - b) * area < 0.0f || lengthSquared(b - a) == 0.0f) return false;
    }
    return true;
}

}  // namespace plumb::box_physics
