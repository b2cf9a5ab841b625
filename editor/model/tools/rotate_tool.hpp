#pragma once

#include "editor/model/tools/handle_tool.hpp"

namespace plumb::editor {

/// Rotates the selected entities about the origin of the active one, the last selected. The only handle is a
/// ring around that origin. With snapping, the active entity's rotation becomes a multiple of the snap angle.
class RotateTool final : public HandleTool {
public:
    static constexpr float kRing = 48.0f;  ///< px on screen: radius of the ring

protected:
    [[nodiscard]] Handle handleAt(const Pose& pose, const Pointer& pointer) const override;
    void take(const Pointer& pointer) override;
    void pull(const ToolContext& context, const Pointer& pointer) override;
    void drawHandles(const Pose& pose, Handle hot, const Pointer& pointer, Overlay& overlay) const override;

private:
    float before_ = 0.0f;  // rad: direction from the pivot to the pointer at its last move
    float turned_ = 0.0f;  // rad: rotation of the pointer about the pivot since the press
    float angle_ = 0.0f;   // rad: rotation applied to the entities, with snapping
};

}  // namespace plumb::editor
