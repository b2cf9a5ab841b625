#pragma once

#include "editor/model/tools/handles.hpp"
#include "editor/model/tools/select_tool.hpp"

namespace plumb::editor {

/// Scales what is selected along its own x, its own y, or both alike. Snapping goes in quarters.
class ScaleTool final : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;

private:
    Handle held_ = Handle::None;
    Vec2 grabPoint_;
    Vec2 factors_{1.0f, 1.0f};
    TransformDrag drag_;
    SelectTool select_;
};

}  // namespace plumb::editor
