#pragma once

#include "editor/model/tools/handles.hpp"
#include "editor/model/tools/select_tool.hpp"

namespace plumb::editor {

/// Moves what is selected by its handles: along x, along y, or freely. Beside them it selects like the
/// select tool.
class MoveTool final : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;

private:
    Handle held_ = Handle::None;
    Vec2 grabPoint_;
    Vec2 offset_;
    TransformDrag drag_;
    SelectTool select_;
};

}  // namespace plumb::editor
