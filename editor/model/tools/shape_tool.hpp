#pragma once

#include "editor/model/tools/select_tool.hpp"
#include "editor/model/tools/shape_handles.hpp"

namespace plumb::editor {

/// Drags the sides and corners of colliders, the anchors of joints, the ends of paths and the pivot of the
/// last selected entity. A press on an outline inserts a corner, Del or Ctrl+click removes one. Elsewhere the
/// tool acts like the select tool. One drag is one undo step.
class ShapeTool final : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;

    [[nodiscard]] bool hasSelectedPart(const ToolContext& context) const override;
    void removeChosen(const ToolContext& context) override;

private:
    void hold(const ToolContext& context, const ShapeHandle& spot, const Pointer& pointer);
    void push(const ToolContext& context, std::vector<ChangeStates::Change> changes) const;
    /// The spot (handle) held last, at its present position; nothing if it does not exist any more.
    [[nodiscard]] std::optional<ShapeHandle> chosen(const ToolContext& context) const;

    ObjectId object_;                          ///< entity of `held_` and `chosen_`
    std::optional<ShapeHandle> held_;          ///< the spot being dragged
    std::optional<ShapeHandle> chosen_;        ///< the spot held last, which Del removes
    std::vector<ChangeStates::Change> start_;  ///< component states at the press
    Vec2 grabPoint_;                           ///< px, world: position of the press
    bool moved_ = false;                       ///< a change was made since the press
    SelectTool select_;
};

}  // namespace plumb::editor
