#include "editor/model/tools/handle_tool.hpp"

#include <utility>

namespace plumb::editor {

/// With Alt held, handles are ignored, so that entities below them can be clicked.
Handle HandleTool::handleUnder(const ToolContext& context, const Pointer& pointer) const {
    if (pointer.modifiers.alt) return Handle::None;
    const std::optional<Pose> pose = activePose(context.document);
    return pose ? handleAt(*pose, pointer) : Handle::None;
}

void HandleTool::press(const ToolContext& context, const Pointer& pointer) {
    held_ = handleUnder(context, pointer);
    if (held_ == Handle::None) return select_.press(context, pointer);
    grabPoint_ = pointer.position;
    drag_.grab(context);
    take(pointer);
}

void HandleTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (held_ == Handle::None) return select_.drag(context, pointer);
    pull(context, pointer);
}

void HandleTool::release(const ToolContext& context, const Pointer& pointer) {
    if (std::exchange(held_, Handle::None) == Handle::None) return select_.release(context, pointer);
    drag_.finish(context);
}

bool HandleTool::cancel(const ToolContext& context) {
    if (std::exchange(held_, Handle::None) == Handle::None) return select_.cancel(context);
    return drag_.cancel(context);
}

void HandleTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    select_.draw(context, pointer, overlay);
    const std::optional<Pose> pose = activePose(context.document);
    if (!pose) return;
    drawHandles(*pose, held_ == Handle::None ? handleAt(*pose, pointer) : held_, pointer, overlay);
}

}  // namespace plumb::editor
