#pragma once

#include "editor/model/tools/handle_tool.hpp"

namespace plumb::editor {

/// Scales what is selected along its own x, its own y, or both alike. Snapping goes in quarters.
class ScaleTool final : public HandleTool {
protected:
    [[nodiscard]] Handle handleAt(const Pose& pose, const Pointer& pointer) const override;
    void take(const Pointer&) override {}
    void pull(const ToolContext& context, const Pointer& pointer) override;
    void drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const override;
};

}  // namespace plumb::editor
