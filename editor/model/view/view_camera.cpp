#include "editor/model/view/view_camera.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::editor {

void ViewCamera::zoomAt(Vec2 screen, float steps) {
    const Vec2 before = toWorldPoint(screen);
    setZoom(view_.zoom * std::pow(1.2f, steps));
    view_.center += before - toWorldPoint(screen);
}

void ViewCamera::setZoom(float zoom) {
    const float kept = std::clamp(zoom, kMinZoom, kMaxZoom);
    // Snaps to a near integer zoom, at which pixel art is sharp.
    const float whole = std::round(kept);
    view_.zoom = whole >= 1.0f && std::abs(kept - whole) < 0.04f * whole ? whole : kept;
}

void ViewCamera::show(Vec2 center, float zoom) {
    view_.center = center;
    view_.zoom = std::clamp(zoom, kMinZoom, kMaxZoom);
}

float ViewCamera::zoomFor(Vec2 picture, float margin) const {
    const Vec2 room = view_.size - Vec2{2.0f * margin, 2.0f * margin};
    const float fit = std::min(room.x / std::max(picture.x, 1.0f), room.y / std::max(picture.y, 1.0f));
    return fit >= 1.0f ? std::floor(fit) : std::max(fit, kMinZoom);
}

void ViewCamera::frame(const AABB& box) {
    const Vec2 size = max(box.size(), {1.0f, 1.0f});
    const float fit = 0.9f * std::min(view_.size.x / size.x, view_.size.y / size.y);
    setZoom(std::min(fit, 8.0f));
    view_.center = box.center();
}

}  // namespace plumb::editor
