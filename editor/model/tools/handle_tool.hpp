#pragma once

#include "editor/model/tools/handles.hpp"
#include "editor/model/tools/select_tool.hpp"

namespace plumb::editor {

/// Base of tools with handles at the active entity, the last selected one. Dragging a handle changes all
/// selected entities; elsewhere the tool acts like the select tool. Derived classes define the hit test, the
/// effect and the drawing of the handles.
class HandleTool : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) final;
    void drag(const ToolContext& context, const Pointer& pointer) final;
    void release(const ToolContext& context, const Pointer& pointer) final;
    bool cancel(const ToolContext& context) final;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const final;

protected:
    /// Returns the handle at the pointer. @param pose  world pose of the active entity
    [[nodiscard]] virtual Handle handleAt(const Pose& pose, const Pointer& pointer) const = 0;
    /// Called when a handle was pressed, after `drag_` has grabbed the selected entities.
    virtual void take(const Pointer& pointer) = 0;
    /// Called when the pointer moves while a handle is held.
    virtual void pull(const ToolContext& context, const Pointer& pointer) = 0;
    /// Draws the handles. @param hot  the handle that is held or under the pointer
    virtual void drawHandles(const Pose& pose, Handle hot, const Pointer& pointer,
                             Overlay& overlay) const = 0;

    [[nodiscard]] Handle held() const { return held_; }
    [[nodiscard]] Vec2 grabPoint() const { return grabPoint_; }  ///< px, world: press

    TransformDrag drag_;

private:
    [[nodiscard]] Handle handleUnder(const ToolContext& context, const Pointer& pointer) const;

    Handle held_ = Handle::None;
    Vec2 grabPoint_;
    SelectTool select_;
};

}  // namespace plumb::editor
