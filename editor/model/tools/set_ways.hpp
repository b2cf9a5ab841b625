#pragma once

#include <optional>
#include <vector>

#include "editor/model/tools/shape_spots.hpp"
#include "editor/model/view/overlay.hpp"

namespace plumb::editor {

/// The way on which a component moves its entity to and fro: that of a platform, or between the limits of
/// something that walks.
struct SetWay {
    Vec2 from;             ///< px, world; of what walks its left end
    Vec2 to;               ///< px, world
    bool endsFrom = true;  ///< false: nothing limits it there
    bool endsTo = true;
    bool walks = false;  ///< to both sides; else away from where it stands
};

/// @param world  the document's, or the one that plays: there it starts from where it stood at the beginning
std::optional<SetWay> setWayOf(const World& world, EntityId entity);

/// The ends of its way that can be dragged.
void addWaySpots(const Document& document, ObjectId id, std::vector<ShapeSpot>& spots);
/// One of them at another place. @param to  px, world
void dragWay(const Document& document, ObjectId id, ComponentState& state, int part, Vec2 to);

/// A line with a mark at each end; dotted marks where it ends at walls and edges alone.
void drawSetWay(const SetWay& way, float pixel, Overlay& overlay);

}  // namespace plumb::editor
