#pragma once

#include "editor/model/tools/transform_drag.hpp"

namespace plumb::editor {

/// Selects entities by a click or by dragging a box, and moves entities by dragging them. Shift adds to the
/// selection, Ctrl toggles; Alt+click selects the next entity below, Alt+drag moves a copy.
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
    bool onThing_ = false;          ///< a drag moves `hit_`, as it is selected or not background
    bool wasSelected_ = false;      ///< `hit_` was selected before the press
    ObjectId hit_;                  ///< the pressed entity; null: none
    Modifiers held_;                ///< modifier keys at the press
    std::vector<ObjectId> copied_;  ///< originals of the dragged copies; empty: no copies
    float reach_ = 0.0f;            ///< px, world: hit distance at the press
    Vec2 start_;                    ///< px, world: position of the press
    Vec2 end_;                      ///< px, world: present position of the pointer
    TransformDrag move_;
};

}  // namespace plumb::editor
