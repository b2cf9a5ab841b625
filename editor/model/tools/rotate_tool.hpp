#pragma once

#include "editor/model/tools/select_tool.hpp"

namespace plumb::editor {

/// Turns what is selected about the origin of the thing in hand, by a ring around it. Snapping turns to
/// multiples of 15 degrees.
class RotateTool final : public Tool {
public:
    static constexpr float kRing = 48.0f;  ///< px on screen

    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const override;

private:
    bool turning_ = false;
    float before_ = 0.0f;  // rad: of the hand, at the last move
    float turned_ = 0.0f;  // rad: by the hand, since the press
    float angle_ = 0.0f;   // rad: of the things, snapped
    TransformDrag drag_;
    SelectTool select_;
};

}  // namespace plumb::editor
