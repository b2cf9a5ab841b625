#pragma once

#include <optional>
#include <vector>

#include "editor/model/commands/change_states.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {

/// Kind of a handle of the shape tool (a spot), which decides its look and the effect of dragging it.
enum class ShapeHandleKind : unsigned char {
    Side,    ///< a side of a box, or a point on a circle
    Corner,  ///< a corner of a box or an outline; those of outlines can be removed
    Middle,  ///< moves the whole shape
    Anchor,  ///< an anchor of a joint
    Way,     ///< an end of the path of a MovingPlatform or a Patrol
    Pivot,   ///< the origin of the entity; sprite, colliders and children keep their world positions
};

/// A handle of the shape tool, also called spot, which changes one component of an entity when dragged.
struct ShapeHandle {
    Vec2 at;                         ///< px, world: position
    const TypeInfo* type = nullptr;  ///< type of the component
    int part = 0;                    ///< index of the handle in the component
    ShapeHandleKind kind = ShapeHandleKind::Corner;
};

/// An edge of a collider; on edges of outlines a corner can be inserted.
struct ShapeEdge {
    Vec2 from;                       ///< px, world: start
    Vec2 to;                         ///< px, world: end
    const TypeInfo* type = nullptr;  ///< type of the collider
    int part = 0;                    ///< index of a corner inserted on this edge
    bool takesCorner = false;        ///< true if a corner can be inserted
};

/// Returns all spots of an entity: of its colliders, joint anchors, path ends and sprite pivot.
std::vector<ShapeHandle> spotsOf(const Document& document, ObjectId id);
/// Returns the edges of the entity's colliders, without the rounding radius.
std::vector<ShapeEdge> edgesOf(const Document& document, ObjectId id);

/// Returns the present states of the components that dragging the spot changes.
std::vector<ChangeStates::Change> statesBehind(const Document& document, ObjectId id,
                                               const ShapeHandle& spot);
/// Computes the states after the spot was dragged.
/// @param start  result of `statesBehind` before the drag
/// @param to     px, world: new position of the spot
std::vector<ChangeStates::Change> draggedTo(const Document& document, ObjectId id, const ShapeHandle& spot,
                                            std::vector<ChangeStates::Change> start, Vec2 to);

/// Returns the component with a corner inserted on an edge; nothing if it has the maximum number of corners.
std::optional<ComponentState> withCorner(const Document& document, ObjectId id, const ShapeEdge& edge,
                                         Vec2 at);
/// Returns the component without a corner; nothing if it has the minimum number of corners.
std::optional<ComponentState> withoutCorner(const Document& document, ObjectId id, const ShapeHandle& corner);

}  // namespace plumb::editor
