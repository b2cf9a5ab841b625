#pragma once

#include "editor/model/tools/transform_drag.hpp"

namespace plumb::editor {

/// Selects by click or by dragging a box; what is dragged by hand moves. Shift adds, Ctrl toggles, Alt takes
/// the next one below, and drags a copy.
class SelectTool final : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;

private:
    enum class Mode : unsigned char { Idle, Pressed, Moving, Boxing };

    void select(const ToolContext& context) const;
    void beginDrag(const ToolContext& context);
    void finishClick(const ToolContext& context, const Pointer& pointer) const;
    void finishBox(const ToolContext& context, const Pointer& pointer) const;

    Mode mode_ = Mode::Idle;
    bool onThing_ = false;
    bool wasSelected_ = false;      ///< what was pressed
    ObjectId hit_;                  ///< what was pressed
    Modifiers held_;                ///< when it was pressed
    std::vector<ObjectId> copied_;  ///< copies of these are dragged
    float reach_ = 0.0f;            ///< px, world: when it was pressed
    Vec2 start_;
    Vec2 end_;
    TransformDrag move_;
};

}  // namespace plumb::editor
