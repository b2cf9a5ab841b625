#pragma once

#include "math/vec2.hpp"

namespace plumb {

/// An axis-aligned box between its top-left and its bottom-right corner.
struct AABB {
    Vec2 min;
    Vec2 max;

    [[nodiscard]] constexpr Vec2 size() const { return max - min; }
    [[nodiscard]] constexpr Vec2 center() const { return (min + max) * 0.5f; }
    friend constexpr bool operator==(const AABB&, const AABB&) = default;
};

/// True if the interiors overlap; boxes that only touch do not.
constexpr bool intersects(const AABB& a, const AABB& b) {
    return a.max.x > b.min.x && a.min.x < b.max.x && a.max.y > b.min.y && a.min.y < b.max.y;
}
constexpr bool contains(const AABB& box, Vec2 point) {
    return point.x >= box.min.x && point.x < box.max.x && point.y >= box.min.y && point.y < box.max.y;
}
constexpr AABB merged(const AABB& a, const AABB& b) { return {min(a.min, b.min), max(a.max, b.max)}; }
constexpr AABB grown(const AABB& box, float margin) {
    return {box.min - Vec2{margin, margin}, box.max + Vec2{margin, margin}};
}

/// A rectangle of an image or of the screen: top-left corner and size.
struct Rect {
    float x = 0.0f;
    float y = 0.0f;
    float width = 0.0f;
    float height = 0.0f;

    [[nodiscard]] constexpr bool empty() const { return width <= 0.0f || height <= 0.0f; }
    friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

}  // namespace plumb
