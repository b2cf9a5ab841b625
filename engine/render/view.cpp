#include "render/view.hpp"

#include <algorithm>
#include <cmath>

#include "math/angle.hpp"

namespace plumb {

Vec2 toScreen(const View& view, Vec2 world) {
    return rotated(world - view.center, -view.rotation) * view.zoom + view.size * 0.5f;
}

Vec2 toWorld(const View& view, Vec2 screen) {
    return rotated((screen - view.size * 0.5f) / view.zoom, view.rotation) + view.center;
}

AABB visibleBox(const View& view) {
    const Vec2 half = view.size * (0.5f / view.zoom);
    if (view.rotation == 0.0f) return {view.center - half, view.center + half};
    const SinCos rotation = sinCos(view.rotation);
    const float c = std::abs(rotation.cos);
    const float s = std::abs(rotation.sin);
    const Vec2 reach{c * half.x + s * half.y, s * half.x + c * half.y};
    return {view.center - reach, view.center + reach};
}

View snappedToPixels(const View& view, float pixelScale) {
    View snapped = view;
    // Snap the corner instead of the center, which is between two px if the size is odd.
    const float grid = view.zoom * pixelScale;
    const Vec2 half = view.size * (0.5f / view.zoom);
    const Vec2 corner = (view.center - half) * grid;
    snapped.center = Vec2{std::floor(corner.x + 0.5f), std::floor(corner.y + 0.5f)} / grid + half;
    return snapped;
}

ViewTransform transformOf(const View& view) {
    const SinCos rotation = sinCos(-view.rotation);
    const float sx = 2.0f * view.zoom / view.size.x;
    const float sy = -2.0f * view.zoom / view.size.y;  // clip space has y up
    ViewTransform transform;
    transform.x = Vec2{rotation.cos, -rotation.sin} * sx;
    transform.y = Vec2{rotation.sin, rotation.cos} * sy;
    return movedBy(transform, -view.center);
}

ViewTransform movedBy(const ViewTransform& transform, Vec2 offset) {
    ViewTransform moved = transform;
    moved.offset += Vec2{dot(transform.x, offset), dot(transform.y, offset)};
    return moved;
}

Viewport viewportFor(WindowScale scale, Vec2 picture, PixelSize window) {
    const Vec2 room{static_cast<float>(window.width), static_cast<float>(window.height)};
    Vec2 factor{room.x / picture.x, room.y / picture.y};
    if (scale == WindowScale::Fit) factor.x = factor.y = std::min(factor.x, factor.y);
    if (scale == WindowScale::Fill) factor.x = factor.y = std::max(factor.x, factor.y);
    if (scale == WindowScale::Integer) {
        const float minimum = std::min(factor.x, factor.y);
        // In a window smaller than the screen no integer factor fits: scale down instead of cropping.
        factor.x = factor.y = minimum >= 1.0f ? std::floor(minimum) : minimum;
    }
    Viewport viewport;
    viewport.width = std::max(1, static_cast<int>(std::lround(picture.x * factor.x)));
    viewport.height = std::max(1, static_cast<int>(std::lround(picture.y * factor.y)));
    viewport.x = (window.width - viewport.width) / 2;
    viewport.y = (window.height - viewport.height) / 2;
    return viewport;
}

Vec2 screenFromWindow(const Viewport& viewport, Vec2 picture, Vec2 position) {
    const Vec2 corner{static_cast<float>(viewport.x), static_cast<float>(viewport.y)};
    const Vec2 size{static_cast<float>(viewport.width), static_cast<float>(viewport.height)};
    const Vec2 inside = position - corner;
    return {inside.x / size.x * picture.x, inside.y / size.y * picture.y};
}

}  // namespace plumb
