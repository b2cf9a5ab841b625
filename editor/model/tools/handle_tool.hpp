#pragma once

#include "editor/model/tools/handles.hpp"
#include "editor/model/tools/select_tool.hpp"

namespace plumb::editor {

/// A tool with handles around the thing in hand: they change what is selected, and beside them it selects
/// like the select tool. A tool says where its handles are, what pulling one does, and how they look.
class HandleTool : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) final;
    void drag(const ToolContext& context, const Pointer& pointer) final;
    void release(const ToolContext& context, const Pointer& pointer) final;
    bool cancel(const ToolContext& context) final;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const final;

protected:
    [[nodiscard]] virtual Handle handleAt(const Pose& pose, const Pointer& pointer) const = 0;
    /// Called once a handle is held; `drag_` has grabbed what is selected.
    virtual void take(const Pointer& pointer) = 0;
    virtual void pull(const ToolContext& context, const Pointer& pointer) = 0;
    /// @param hot  the handle that is held or under the mouse
    virtual void drawHandles(const Pose& pose, Handle hot, const Pointer& pointer,
                             Overlay& overlay) const = 0;

    [[nodiscard]] Handle held() const { return held_; }
    [[nodiscard]] Vec2 grabPoint() const { return grabPoint_; }  ///< px, world

    TransformDrag drag_;

private:
    [[nodiscard]] Handle handleUnder(const ToolContext& context, const Pointer& pointer) const;

    Handle held_ = Handle::None;
    Vec2 grabPoint_;
    SelectTool select_;
};

}  // namespace plumb::editor
