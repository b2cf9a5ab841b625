#pragma once

#include <vector>

#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

/// Complete state of one entity of the scene, from which it can be recreated exactly.
struct EntityState {
    ObjectId id;
    ObjectId parent;
    std::vector<ComponentState> components;  ///< in the order of the registry
};

EntityState readEntity(const Document& document, ObjectId id);

/// Creates entities. Parents must come before their children in the list. References among the entities are
/// resolved.
void insertEntities(Document& document, const std::vector<EntityState>& states);
/// Removes entities and all their descendants from the world.
void eraseEntities(Document& document, const std::vector<ObjectId>& ids);

/// Returns the entities and all their descendants, each once, sorted by depth in the tree, then by file
/// order.
std::vector<ObjectId> withDescendants(const Document& document, const std::vector<ObjectId>& ids);

/// Returns those of `ids` that have no ancestor among `ids`: moving these moves each entity once.
std::vector<ObjectId> outermost(const Document& document, const std::vector<ObjectId>& ids);

/// Returns copies with new ids for pasting. References among the entities point to the copies; tile grids are
/// copied. In the file, the copies come after all other entities.
std::vector<EntityState> copiesOf(Document& document, std::vector<EntityState> states);

}  // namespace plumb::editor
