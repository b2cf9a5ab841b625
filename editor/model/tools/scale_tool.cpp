#include "editor/model/tools/scale_tool.hpp"

#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "math/angle.hpp"

namespace plumb::editor {
namespace {

constexpr float kSnapScale = 0.25f;  // ratio

Handle handleUnder(const ToolContext& context, const Pointer& pointer) {
    const std::optional<Pose> pose = poseInHand(context.document);
    if (!pose) return Handle::None;
    return AxisHandles{pose->position, pose->rotation, pointer.pixel}.at(pointer.position);
}

/// The factor of one axis so that the thing in hand gets a scale in steps, and never none at all.
float snappedFactor(float factor, float scale, bool snap) {
    if (scale == 0.0f) return 1.0f;
    const float step = snap ? kSnapScale : 0.01f;
    const float steps = std::round(scale * factor / step);
    return (steps == 0.0f ? std::copysign(1.0f, scale) : steps) * step / scale;
}

}  // namespace

void ScaleTool::press(const ToolContext& context, const Pointer& pointer) {
    held_ = handleUnder(context, pointer);
    if (held_ == Handle::None) return select_.press(context, pointer);
    grabPoint_ = pointer.position;
    factors_ = {1.0f, 1.0f};
    drag_.grab(context);
}

void ScaleTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (held_ == Handle::None) return select_.drag(context, pointer);
    const Pose& pivot = drag_.pivot();
    // A drag as long as an arm makes it twice as large, wherever the arm was taken.
    const Vec2 way =
        rotated(pointer.position - grabPoint_, -pivot.rotation) / (AxisHandles::kArm * pointer.pixel);
    const float both = 1.0f + (way.x + way.y) * 0.5f;
    if (held_ == Handle::Both) {
        const float factor = snappedFactor(both, pivot.scale.x, pointer.snap);
        factors_ = {factor, factor};
    } else {
        factors_ = {held_ == Handle::X ? snappedFactor(1.0f + way.x, pivot.scale.x, pointer.snap) : 1.0f,
                    held_ == Handle::Y ? snappedFactor(1.0f + way.y, pivot.scale.y, pointer.snap) : 1.0f};
    }
    drag_.scale(context, factors_);
}

void ScaleTool::release(const ToolContext& context, const Pointer& pointer) {
    if (std::exchange(held_, Handle::None) == Handle::None) return select_.release(context, pointer);
    drag_.finish(context);
}

bool ScaleTool::cancel(const ToolContext& context) {
    if (std::exchange(held_, Handle::None) == Handle::None) return select_.cancel(context);
    return drag_.cancel(context);
}

void ScaleTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    select_.draw(context, pointer, overlay);
    const std::optional<Pose> pose = poseInHand(context.document);
    if (!pose) return;
    const Handle hot = held_ == Handle::None ? handleUnder(context, pointer) : held_;
    const AxisHandles handles{pose->position, pose->rotation, pointer.pixel};
    handles.draw(overlay, hot, true);
    if (held_ == Handle::None) return;
    const Vec2 place = handles.middleOf(Handle::Both) + Vec2{14.0f, 0.0f} * pointer.pixel;
    overlay.text(place, format("{} x {}", pose->scale.x, pose->scale.y), handle_colors::kHot);
}

}  // namespace plumb::editor
