#include "physics/shapes/hull.hpp"

#include <algorithm>
#include <vector>

#include "core/text.hpp"
#include "physics/ranges.hpp"
#include "physics/shapes/exact.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// The part of the hull below all points, or above them if the points are sorted in descending order.
void appendChain(std::span<const Vec2> sorted, std::vector<Vec2>& loop) {
    const std::size_t start = loop.size();
    for (const Vec2 point : sorted) {
        while (loop.size() >= start + 2 && areaOf(loop[loop.size() - 2], loop.back(), point) <= 0.0)
            loop.pop_back();
        loop.push_back(point);
    }
    loop.pop_back();  // it is the first corner of the other part
}

std::vector<Vec2> loopAround(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Vec2> loop;
    if (points.size() < 3) return loop;
    appendChain(points, loop);
    std::reverse(points.begin(), points.end());
    appendChain(points, loop);
    return loop;
}

/// m: distance of `point` from the line through a and b; from a if both are equal.
double heightOver(Vec2 a, Vec2 b, Vec2 point) {
    const double x = static_cast<double>(b.x) - static_cast<double>(a.x);
    const double y = static_cast<double>(b.y) - static_cast<double>(a.y);
    const double size = std::sqrt(x * x + y * y);
    return size > 0.0 ? std::fabs(areaOf(a, b, point)) / size : static_cast<double>(distance(a, point));
}

/// Removes the flattest corner repeatedly, as long as it protrudes by less than `height`.
void dropFlat(std::vector<Vec2>& loop, double height) {
    while (loop.size() >= 3) {
        std::size_t flattest = 0;
        double minimum = height;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 before = loop[i > 0 ? i - 1 : loop.size() - 1];
            const Vec2 after = loop[i + 1 < loop.size() ? i + 1 : 0];
            const double over = heightOver(before, after, loop[i]);
            if (over < minimum) {
                minimum = over;
                flattest = i;
            }
        }
        if (minimum >= height) return;
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(flattest));
    }
}

Vec2 normalOfFace(Vec2 from, Vec2 to) {
    const double x = static_cast<double>(to.y) - static_cast<double>(from.y);
    const double y = static_cast<double>(from.x) - static_cast<double>(to.x);
    const double size = std::sqrt(x * x + y * y);
    return {static_cast<float>(x / size), static_cast<float>(y / size)};
}

/// Area and centroid. Computed relative to the first corner, so that a polygon far from the origin loses no
/// accuracy.
void measure(Hull& hull) {
    const Vec2 origin = hull.corners[0].point;
    double twice = 0.0;
    double x = 0.0;
    double y = 0.0;
    for (std::size_t i = 1; i + 1 < hull.corners.size(); ++i) {
        const Vec2 a = hull.corners[i].point;
        const Vec2 b = hull.corners[i + 1].point;
        const double part = areaOf(origin, a, b);
        twice += part;
        x += part * (static_cast<double>(a.x - origin.x) + static_cast<double>(b.x - origin.x));
        y += part * (static_cast<double>(a.y - origin.y) + static_cast<double>(b.y - origin.y));
    }
    hull.area = static_cast<float>(0.5 * twice);
    hull.centroid =
        origin + Vec2{static_cast<float>(x / (3.0 * twice)), static_cast<float>(y / (3.0 * twice))};
}

}  // namespace

Result<Hull> makeHull(std::span<const Vec2> points) {
    const auto error = [](std::string what, const char* remedy) {
        return Error{"hull", std::move(what), remedy};
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 point = points[i];
        if (std::fabs(point.x) <= kLargest && std::fabs(point.y) <= kLargest) continue;
        return error(format("point {} is ({}, {}), not within {} m", i, point.x, point.y, kLargest),
                     "use metres, not pixels, relative to the origin of the body");
    }
    std::vector<Vec2> loop = loopAround({points.begin(), points.end()});
    if (loop.size() < 3) {
        return error(format("the {} points form no area", points.size()),
                     "pass at least 3 that are not on one line");
    }
    constexpr std::size_t kAbsurd = 4096;
    AABB box{loop[0], loop[0]};
    for (const Vec2 point : loop) box = merged(box, {point, point});
    const float size = std::max(box.size().x, box.size().y);
    if (!(size >= kSmallest)) {
        return error(format("it is only {} m large", size), "make it at least 0.1 mm large");
    }
    if (loop.size() <= kAbsurd) dropFlat(loop, static_cast<double>(kBlur * size));
    if (loop.size() < 3) return error("it is too thin to have an inside", "use a segment or a capsule");
    if (loop.size() > kMaxCorners) {
        return error(format("it has {} corners, the maximum is {}", loop.size(), kMaxCorners),
                     "remove some, use a circle, or decompose()");
    }
    Hull hull;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 next = loop[i + 1 < loop.size() ? i + 1 : 0];
        hull.corners.push({loop[i], normalOfFace(loop[i], next)});
    }
    measure(hull);
    return hull;
}

Geometry polygon(const Hull& hull, std::uint32_t first, float radius) {
    return {.kind = ShapeKind::Polygon,
            .count = static_cast<std::uint8_t>(hull.corners.size()),
            .first = first,
            .radius = radius,
            .a = hull.centroid,
            .b = {}};
}

}  // namespace plumb::physics
