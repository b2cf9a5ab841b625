#pragma once

#include <string_view>
#include <vector>

#include "editor/model/tools/tool.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {

/// Moves, rotates and scales the selected entities relative to their poses at the start of the drag. One drag
/// is one undo step. Entities below another selected one follow it; locked entities stay.
class TransformDrag {
public:
    /// Starts a drag of the selected entities.
    void grab(const ToolContext& context);
    void move(const ToolContext& context, Vec2 offset);    ///< px, world: displacement since `grab`
    void turn(const ToolContext& context, float angle);    ///< rad: rotation about the pivot since `grab`
    void scale(const ToolContext& context, Vec2 factors);  ///< ratio since `grab`, along each entity's axes
    /// Ends the drag and its undo step.
    void finish(const ToolContext& context);
    /// Undoes the drag. @return false if nothing was grabbed
    bool cancel(const ToolContext& context);

    [[nodiscard]] bool holds() const { return !grabbed_.empty(); }
    /// World pose of the active entity at the start of the drag.
    [[nodiscard]] const Pose& pivot() const { return pivot_; }
    /// The point of the active entity that snaps to the grid (px, world).
    [[nodiscard]] Vec2 snapPoint(Vec2 grid) const;

private:
    struct Grabbed {
        ObjectId object;
        Transform start;  // Transform at the start of the drag
        Pose world;       // world pose at the start of the drag
        Pose parent;      // world pose of the parent
    };

    void push(const ToolContext& context, std::string_view verb, std::vector<Transform> targets) const;

    Pose pivot_;
    Vec2 size_;    // px: size of the active entity's sprite; zero if it is rotated or scaled
    Vec2 anchor_;  // pivot of the sprite, ratio of `size_`
    std::vector<Grabbed> grabbed_;
};

/// Returns the world pose of the active entity: the last selected one with a Transform. Nothing if there is
/// none.
std::optional<Pose> activePose(const Document& document);

/// Returns the offset from the point of a sprite that snaps to the grid to its origin, px. A sprite whose
/// size is a multiple of the grid cell snaps by its upper left corner, so that it covers whole cells; any
/// other by its origin.
/// @param pivot  ratio of the size
Vec2 snapOffset(Vec2 size, Vec2 pivot, Vec2 grid);

/// Returns the displacement of a drag. Shift restricts it to one axis; the result snaps to the grid, or to
/// whole pixels.
/// @param snapPoint  px, world: the point that snaps, before the drag
Vec2 dragOffset(Vec2 grabPoint, Vec2 snapPoint, const Pointer& pointer);

/// Converts an offset in the world to the coordinates of a rotated and scaled parent.
Vec2 inParent(Vec2 offset, const Pose& parent);

/// Moves the selected entities by an offset (px, world), as a change of the present undo gesture.
void nudge(const ToolContext& context, Vec2 offset);

}  // namespace plumb::editor
