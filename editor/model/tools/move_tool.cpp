#include "editor/model/tools/move_tool.hpp"

namespace plumb::editor {

Handle MoveTool::handleAt(const Pose& pose, const Pointer& pointer) const {
    return AxisHandles{pose.position, 0.0f, pointer.pixel}.at(pointer.position);
}

void MoveTool::take(const Pointer&) { offset_ = {}; }

void MoveTool::pull(const ToolContext& context, const Pointer& pointer) {
    Pointer along = pointer;
    if (held() == Handle::X) along.position.y = grabPoint().y;
    if (held() == Handle::Y) along.position.x = grabPoint().x;
    offset_ = dragOffset(grabPoint(), drag_.snapPoint(pointer.grid), along);
    drag_.move(context, offset_);
}

void MoveTool::drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const {
    if (held() != Handle::None) {
        const Vec2 from = drag_.pivot().position;
        overlay.line(from, from + offset_, handle_colors::kHot);
    }
    AxisHandles{pose.position, 0.0f, pointer.pixel}.draw(overlay, hot, false);
}

}  // namespace plumb::editor
