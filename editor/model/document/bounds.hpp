#pragma once

#include <optional>
#include <vector>

#include "editor/model/document/document.hpp"
#include "math/rect.hpp"

namespace plumb::editor {

/// Whether an entity has a place. One without, e.g. a key, can neither be clicked nor framed.
bool isSomewhere(const World& world, EntityId entity);

/// What is everywhere: tile layers, fields, and sprites that fill the game's picture. Others come before it,
/// and a drag that begins on it moves it only when it is selected already.
bool isGround(const Document& document, EntityId entity);

/// The box around what can be seen of an entity (px, world); a small one where there is nothing to see.
AABB boundsOf(const World& world, EntityId entity);

/// The box around several; nothing when there are none.
std::optional<AABB> boundsOf(const Document& document, const std::vector<ObjectId>& objects);

/// What lies under a point, front first; the mouse goes through what is hidden or locked, and through the
/// holes of tile layers. The ground comes last.
std::vector<ObjectId> pickAll(const Document& document, Vec2 point, float reach);

/// What a click takes: the front-most thing, and the whole instance where that is a part of a prefab, unless
/// the part is selected already. Null where nothing is.
ObjectId pickFirst(const Document& document, Vec2 point, float reach);

/// What a dragged box touches, whole instances as with a click; the ground is left out.
std::vector<ObjectId> pickInside(const Document& document, const AABB& box);

}  // namespace plumb::editor
