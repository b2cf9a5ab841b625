#pragma once

#include <string_view>
#include <vector>

#include "editor/model/tools/tool.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {

/// Moves, turns and scales what is selected, always from where it was when it was grabbed. One drag is one
/// step of undo; what is below another selected thing goes with it, and what is locked stays.
class TransformDrag {
public:
    void grab(const ToolContext& context);
    void move(const ToolContext& context, Vec2 offset);    ///< px, world
    void turn(const ToolContext& context, float angle);    ///< rad, about the pivot
    void scale(const ToolContext& context, Vec2 factors);  ///< ratio, along the axes of each thing
    void finish(const ToolContext& context);
    /// @return false when nothing was grabbed
    bool cancel(const ToolContext& context);

    [[nodiscard]] bool holds() const { return !grabbed_.empty(); }
    /// The pose in the world of the thing in hand, when it was grabbed.
    [[nodiscard]] const Pose& pivot() const { return pivot_; }
    /// px, world: the point of it that snaps.
    [[nodiscard]] Vec2 snapPoint(Vec2 grid) const;

private:
    struct Grabbed {
        ObjectId object;
        Transform start;
        Pose world;
        Pose parent;
    };

    void push(const ToolContext& context, std::string_view verb, std::vector<Transform> targets) const;

    Pose pivot_;
    Vec2 size_;    // px: of its picture, if that is neither turned nor scaled
    Vec2 anchor_;  // ratio of it
    std::vector<Grabbed> grabbed_;
};

/// The pose in the world of the thing in hand: the last one selected that is somewhere. Nothing without one.
std::optional<Pose> poseInHand(const Document& document);

/// px, from the corner of a picture that snaps to its origin: a picture of whole cells comes to lie in cells,
/// wherever its pivot is. Any other one snaps by its origin.
/// @param pivot  ratio of the size
Vec2 snapOffset(Vec2 size, Vec2 pivot, Vec2 grid);

/// How far a drag moves: Shift keeps to one axis, and what moves comes to the grid or to whole pixels.
/// @param snapPoint  px, world: before the drag
Vec2 dragOffset(Vec2 grabPoint, Vec2 snapPoint, const Pointer& pointer);

/// An offset in the world as one in a parent that is turned and scaled.
Vec2 inParent(Vec2 offset, const Pose& parent);

/// Moves what is selected by px of the world: one change of a gesture.
void nudge(const ToolContext& context, Vec2 offset);

}  // namespace plumb::editor
