#include <algorithm>
#include <array>
#include <cmath>

#include "math/angle.hpp"
#include "render/draw_list.hpp"

// Shapes of a draw list. Lines become thin sprites of the white pixel, so that they share the draw
// call of adjacent sprites; only filled circles and polygons are drawn as triangles.
namespace plumb {
namespace {

constexpr int kMaxSegments = 64;

/// Returns the number of segments of a circle for an error below a quarter of a screen px.
int segmentsFor(float radius, float zoom) {
    return std::clamp(8 + static_cast<int>(std::min(radius * zoom, 1000.0f) * 0.5f), 8, kMaxSegments);
}

std::span<const Vec2> circleCorners(Vec2 center, float radius, int count,
                                    std::array<Vec2, kMaxSegments>& corners) {
    for (int i = 0; i < count; ++i) {
        const SinCos angle = sinCos(kTau * static_cast<float>(i) / static_cast<float>(count));
        corners[static_cast<std::size_t>(i)] = center + Vec2{angle.cos, angle.sin} * radius;
    }
    return {corners.data(), static_cast<std::size_t>(count)};
}

}  // namespace

void DrawList::line(Vec2 from, Vec2 to, const ShapeStyle& style) {
    const Vec2 along = to - from;
    const float half = style.thickness * 0.5f / view_.zoom;
    SpriteQuad quad;
    quad.center = (from + to) * 0.5f;
    // Culls before the angle is computed, which is the most expensive part.
    if (!isInView(quad.center, {std::abs(along.x) * 0.5f + half, std::abs(along.y) * 0.5f + half}, 0.0f)) {
        ++culled_;
        return;
    }
    if (along.x == 0.0f) {
        quad.half = {half, std::abs(along.y) * 0.5f};
    } else {
        quad.half = {length(along) * 0.5f, half};
        quad.rotation = along.y == 0.0f ? 0.0f : arcTangent(along.y, along.x);
    }
    quad.source = {0.0f, 0.0f, 1.0f, 1.0f};
    quad.tint = style.color;
    quad.layer = style.layer;
    sprite(quad);
}

void DrawList::arrow(Vec2 from, Vec2 to, const ShapeStyle& style) {
    line(from, to, style);
    const Vec2 along = normalized(to - from);
    const float head = std::min(6.0f * style.thickness / view_.zoom, distance(from, to) * 0.5f);
    const Vec2 neck = to - along * head;
    const Vec2 side = perpendicular(along) * (head * 0.5f);
    line(to, neck + side, style);
    line(to, neck - side, style);
}

void DrawList::rect(const AABB& box, const ShapeStyle& style) {
    const std::array corners{box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}};
    polygon(corners, style);
}

void DrawList::circle(Vec2 center, float radius, const ShapeStyle& style) {
    std::array<Vec2, kMaxSegments> corners;
    polygon(circleCorners(center, radius, segmentsFor(radius, view_.zoom), corners), style);
}

void DrawList::polygon(std::span<const Vec2> corners, const ShapeStyle& style) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        line(corners[i], corners[(i + 1) % corners.size()], style);
}

void DrawList::filledRect(const AABB& box, Color color, int layer) {
    SpriteQuad quad;
    quad.center = box.center();
    quad.half = box.size() * 0.5f;
    quad.source = {0.0f, 0.0f, 1.0f, 1.0f};
    quad.tint = color;
    quad.layer = layer;
    sprite(quad);
}

void DrawList::filledCircle(Vec2 center, float radius, Color color, int layer) {
    std::array<Vec2, kMaxSegments> corners;
    fan(circleCorners(center, radius, segmentsFor(radius, view_.zoom), corners), color, layer);
}

void DrawList::filledPolygon(std::span<const Vec2> corners, Color color, int layer) {
    fan(corners, color, layer);
}

void DrawList::fan(std::span<const Vec2> corners, Color color, int layer) {
    if (corners.size() < 3) return;
    AABB box{corners.front(), corners.front()};
    for (const Vec2 corner : corners) box = merged(box, {corner, corner});
    if (!isInView(box.center(), box.size() * 0.5f, 0.0f)) {
        ++culled_;
        return;
    }
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (std::size_t i = 2; i < corners.size(); ++i) {
        for (const Vec2 corner : {corners[0], corners[i - 1], corners[i]})
            vertices_.push_back({corner, color});
    }
    add(Kind::Geometry, triangles_.size(), drawKey(layer, 0, 0));
    triangles_.push_back({first, static_cast<std::uint32_t>(vertices_.size()) - first});
}

}  // namespace plumb
