#pragma once

#include "editor/model/tools/tool.hpp"

namespace plumb::editor {

/// Moves what is selected. Shift keeps to one axis.
class MoveTool final : public Tool {
public:
    void press(const ToolContext& context, const Pointer& pointer) override;
    void drag(const ToolContext& context, const Pointer& pointer) override;
    void release(const ToolContext& context, const Pointer& pointer) override;
    bool cancel(const ToolContext& context) override;
    void draw(const Document& document, const Pointer& pointer, Overlay& overlay) const override;

private:
    struct Grabbed {
        ObjectId object;
        Vec2 start;         // px, in the parent
        float parentAngle;  // rad
        Vec2 parentScale;
    };

    Vec2 grabPoint_;
    Vec2 origin_;  // px, world: of the thing under the hand; it is what snaps
    Vec2 offset_;
    std::vector<Grabbed> grabbed_;
};

/// Moves what is selected by px of the world: one change of a gesture.
void nudge(const ToolContext& context, Vec2 offset);

}  // namespace plumb::editor
