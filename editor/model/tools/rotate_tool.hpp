#pragma once

#include "editor/model/tools/handle_tool.hpp"

namespace plumb::editor {

/// Turns what is selected about the origin of the thing in hand, by a ring around it: its one handle.
/// Snapping turns to multiples of 15 degrees.
class RotateTool final : public HandleTool {
public:
    static constexpr float kRing = 48.0f;  ///< px on screen

protected:
    [[nodiscard]] Handle handleAt(const Pose& pose, const Pointer& pointer) const override;
    void take(const Pointer& pointer) override;
    void pull(const ToolContext& context, const Pointer& pointer) override;
    void drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const override;

private:
    float before_ = 0.0f;  // rad: of the hand, at the last move
    float turned_ = 0.0f;  // rad: by the hand, since the press
    float angle_ = 0.0f;   // rad: of the things, snapped
};

}  // namespace plumb::editor
