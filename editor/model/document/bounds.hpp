#pragma once

#include <optional>
#include <vector>

#include "editor/model/document/document.hpp"
#include "math/rect.hpp"

namespace plumb::editor {

/// True if the entity has a Transform. An entity without one cannot be picked or framed.
bool hasTransform(const World& world, EntityId entity);

/// True for background entities: tile layers, parallax layers, force fields with a region, and sprites at
/// least as large as the game's viewport. Other entities are picked before them. A drag that begins on a
/// background entity moves it only if it is already selected; otherwise it drags a selection box.
bool isBackground(const Document& document, EntityId entity);

/// Returns the world box (px) around an entity's sprite, tiles, text, colliders, soft body and region; a
/// small box at its position if it has none of these.
AABB boundsOf(const World& world, EntityId entity);

/// Returns the box around several entities; nullopt if none has a finite box.
std::optional<AABB> boundsOf(const Document& document, const std::vector<ObjectId>& objects);

/// Returns the entities under a point, front first, background entities (isBackground) last. Skips hidden and
/// locked entities, and tile layers whose cell at the point is empty. @param reach  px around the point
std::vector<ObjectId> pickAll(const Document& document, Vec2 point, float reach);

/// Returns the entity that a click selects: the front-most one; for a part of a prefab instance, the root of
/// the instance unless the part is already selected. Null if there is none.
ObjectId pickFirst(const Document& document, Vec2 point, float reach);

/// Returns the entities that a selection box touches, without background entities. For a part of a prefab
/// instance, returns the root of the instance unless the part is already selected.
std::vector<ObjectId> pickInside(const Document& document, const AABB& box);

}  // namespace plumb::editor
