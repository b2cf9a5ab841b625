#pragma once

#include <optional>
#include <vector>

#include "editor/model/commands/change_states.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {

/// What a spot is, and so how it looks and how it is dragged.
enum class SpotKind : unsigned char {
    Side,    ///< of a box, or on a circle
    Corner,  ///< of a box, or of an outline: an outline's can be taken out
    Middle,  ///< moves the whole shape
    Anchor,  ///< of a joint
    Way,     ///< an end of the way on which it moves by itself
    Pivot,   ///< the origin of the entity; what hangs on it stays where it is
};

/// A place at an entity by which one of its components is changed by hand.
struct ShapeSpot {
    Vec2 at;  ///< px, world
    const TypeInfo* type = nullptr;
    int part = 0;  ///< which of the component's
    SpotKind kind = SpotKind::Corner;
};

/// A line between two corners of an outline, where another corner can be put in.
struct ShapeEdge {
    Vec2 from;  ///< px, world
    Vec2 to;    ///< px, world
    const TypeInfo* type = nullptr;
    int part = 0;  ///< the number that a new corner gets
    bool takesCorner = false;
};

/// All spots of an entity: colliders, anchors of joints, ends of its way, the pivot of a picture.
std::vector<ShapeSpot> spotsOf(const Document& document, ObjectId id);
/// The outlines of its colliders as they are edited, without rounding.
std::vector<ShapeEdge> edgesOf(const Document& document, ObjectId id);

/// The components that change when a spot is dragged, as they are now.
std::vector<ChangeStates::Change> statesBehind(const Document& document, ObjectId id, const ShapeSpot& spot);
/// The same with the spot at another place. @param to  px, world
std::vector<ChangeStates::Change> draggedTo(const Document& document, ObjectId id, const ShapeSpot& spot,
                                            std::vector<ChangeStates::Change> start, Vec2 to);

/// The component with one more corner, or one less. Nothing when there is no room for it, or too few are
/// left.
std::optional<ComponentState> withCorner(const Document& document, ObjectId id, const ShapeEdge& edge,
                                         Vec2 at);
std::optional<ComponentState> withoutCorner(const Document& document, ObjectId id, const ShapeSpot& corner);

}  // namespace plumb::editor
