#pragma once

#include "editor/model/tools/handle_tool.hpp"

namespace plumb::editor {

/// Scales the selected entities along their own x axis, their own y axis, or both equally. With snapping, the
/// active entity's scale becomes a multiple of 0.25.
class ScaleTool final : public HandleTool {
protected:
    [[nodiscard]] Handle handleAt(const Pose& pose, const Pointer& pointer) const override;
    void take(const Pointer&) override {}
    void pull(const ToolContext& context, const Pointer& pointer) override;
    void drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const override;
};

}  // namespace plumb::editor
