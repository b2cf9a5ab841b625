#pragma once

#include "editor/model/tools/handle_tool.hpp"

namespace plumb::editor {

/// Moves the selected entities along x, along y, or freely.
class MoveTool final : public HandleTool {
protected:
    [[nodiscard]] Handle handleAt(const Pose& pose, const Pointer& pointer) const override;
    void take(const Pointer& pointer) override;
    void pull(const ToolContext& context, const Pointer& pointer) override;
    void drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const override;

private:
    Vec2 offset_;  // px, world: displacement since the press
};

}  // namespace plumb::editor
