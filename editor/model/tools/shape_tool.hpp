#pragma once

#include "editor/model/tools/select_tool.hpp"
#include "editor/model/tools/shape_spots.hpp"

namespace plumb::editor {

/// Drags the sides and corners of colliders, the anchors of joints and the pivot of the thing in hand. A
/// press on an outline puts a corner in, Del or Ctrl+click takes one out; beside all that it selects like the
/// select tool. One drag is one step of undo.
class ShapeTool final : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;

    [[nodiscard]] bool hasChosen(const ToolContext& context) const override;
    void removeChosen(const ToolContext& context) override;

private:
    void hold(const ToolContext& context, const ShapeSpot& spot, const Pointer& pointer);
    void push(const ToolContext& context, std::vector<ChangeStates::Change> changes) const;
    /// The spot that was held last, where it is now.
    [[nodiscard]] std::optional<ShapeSpot> chosen(const ToolContext& context) const;

    ObjectId object_;  ///< whose spot is, or was, held
    std::optional<ShapeSpot> held_;
    std::optional<ShapeSpot> chosen_;  ///< held last: what Del takes out
    std::vector<ChangeStates::Change> start_;
    Vec2 grabPoint_;  ///< px, world
    bool moved_ = false;
    SelectTool select_;
};

}  // namespace plumb::editor
