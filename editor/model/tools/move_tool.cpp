#include "editor/model/tools/move_tool.hpp"

#include <utility>

namespace plumb::editor {
namespace {

Handle handleUnder(const ToolContext& context, const Pointer& pointer) {
    const std::optional<Pose> pose = poseInHand(context.document);
    return pose ? AxisHandles{pose->position, 0.0f, pointer.pixel}.at(pointer.position) : Handle::None;
}

}  // namespace

void MoveTool::press(const ToolContext& context, const Pointer& pointer) {
    held_ = handleUnder(context, pointer);
    if (held_ == Handle::None) return select_.press(context, pointer);
    grabPoint_ = pointer.position;
    offset_ = {};
    drag_.grab(context);
}

void MoveTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (held_ == Handle::None) return select_.drag(context, pointer);
    Pointer along = pointer;
    if (held_ == Handle::X) along.position.y = grabPoint_.y;
    if (held_ == Handle::Y) along.position.x = grabPoint_.x;
    offset_ = dragOffset(grabPoint_, drag_.pivot().position, along);
    drag_.move(context, offset_);
}

void MoveTool::release(const ToolContext& context, const Pointer& pointer) {
    if (std::exchange(held_, Handle::None) == Handle::None) return select_.release(context, pointer);
    drag_.finish(context);
}

bool MoveTool::cancel(const ToolContext& context) {
    if (std::exchange(held_, Handle::None) == Handle::None) return select_.cancel(context);
    return drag_.cancel(context);
}

void MoveTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    select_.draw(context, pointer, overlay);
    const std::optional<Pose> pose = poseInHand(context.document);
    if (!pose) return;
    const Handle hot = held_ == Handle::None ? handleUnder(context, pointer) : held_;
    if (held_ != Handle::None) {
        const Vec2 from = drag_.pivot().position;
        overlay.line(from, from + offset_, handle_colors::kHot);
    }
    AxisHandles{pose->position, 0.0f, pointer.pixel}.draw(overlay, hot, false);
}

}  // namespace plumb::editor
