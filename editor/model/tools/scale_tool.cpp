#include "editor/model/tools/scale_tool.hpp"

#include <cmath>

#include "core/text.hpp"
#include "math/angle.hpp"

namespace plumb::editor {
namespace {

constexpr float kSnapScale = 0.25f;  // step of the scale with snapping

AxisHandles handlesOf(const Pose& pose, const Pointer& pointer) {
    return {pose.position, pose.rotation, pointer.pixel};
}

/// Rounds a scale factor so that `scale` times the factor is a multiple of the snap step, and never 0.
float snappedFactor(float factor, float scale, bool snap) {
    if (scale == 0.0f) return 1.0f;
    const float step = snap ? kSnapScale : 0.01f;
    const float steps = std::round(scale * factor / step);
    return (steps == 0.0f ? std::copysign(1.0f, scale) : steps) * step / scale;
}

}  // namespace

Handle ScaleTool::handleAt(const Pose& pose, const Pointer& pointer) const {
    return handlesOf(pose, pointer).at(pointer.position);
}

void ScaleTool::pull(const ToolContext& context, const Pointer& pointer) {
    const Pose& pivot = drag_.pivot();
    // A drag by the length of an arm doubles the size, wherever on the arm it started.
    const Vec2 way =
        rotated(pointer.position - grabPoint(), -pivot.rotation) / (AxisHandles::kArm * pointer.pixel);
    Vec2 factors{1.0f, 1.0f};
    if (held() == Handle::Both) {
        factors.x = snappedFactor(1.0f + (way.x + way.y) * 0.5f, pivot.scale.x, pointer.snap);
        factors.y = factors.x;
    }
    if (held() == Handle::X) factors.x = snappedFactor(1.0f + way.x, pivot.scale.x, pointer.snap);
    if (held() == Handle::Y) factors.y = snappedFactor(1.0f + way.y, pivot.scale.y, pointer.snap);
    drag_.scale(context, factors);
}

void ScaleTool::drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const {
    const AxisHandles handles = handlesOf(pose, pointer);
    handles.draw(overlay, hot, true);
    if (held() == Handle::None) return;
    const Vec2 place = handles.middleOf(Handle::Both) + Vec2{14.0f, 0.0f} * pointer.pixel;
    overlay.text(place, format("{} x {}", pose.scale.x, pose.scale.y), handle_colors::kHot);
}

}  // namespace plumb::editor
