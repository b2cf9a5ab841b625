#pragma once

#include <optional>
#include <vector>

#include "editor/model/tools/shape_handles.hpp"
#include "editor/model/view/overlay.hpp"

namespace plumb::editor {

/// The path along which a MovingPlatform or a Patrol component moves its entity back and forth.
struct MotionPath {
    Vec2 from;             ///< px, world: start of a platform's path, or left end of a patrol
    Vec2 to;               ///< px, world: other end
    bool endsFrom = true;  ///< the path ends at `from`; false: no limit on this side
    bool endsTo = true;    ///< the path ends at `to`; false: no limit on this side
    bool walks = false;    ///< true: a patrol; false: a platform
};

/// Returns the path of an entity; nothing if it has neither component.
/// @param world  the document's, or that of the running game, where the path starts from the initial position
std::optional<MotionPath> motionPathOf(const World& world, EntityId entity);

/// Appends handles for the ends of the entity's path that can be dragged.
void addWaySpots(const Document& document, ObjectId id, std::vector<ShapeHandle>& spots);
/// Moves an end of the path in `state`. @param part  `ShapeHandle::part` of that end @param to  px, world
void dragWay(const Document& document, ObjectId id, ComponentState& state, int part, Vec2 to);

/// Draws a path as a line with a mark at each end: a bar at a limit, a circle if only walls or edges end the
/// path.
void drawSetWay(const MotionPath& way, float pixel, Overlay& overlay);

}  // namespace plumb::editor
