#pragma once

#include <vector>

#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

/// All there is to know about one entity of the scene, so that it can be made again exactly.
struct EntityState {
    ObjectId id;
    ObjectId parent;
    std::vector<ComponentState> components;  ///< in the order of the registry
};

EntityState readEntity(const Document& document, ObjectId id);

/// Makes entities, parents before their children as the list has them. References among them hold.
void insertEntities(Document& document, const std::vector<EntityState>& states);
/// Takes entities out of the world; children that are not named go with their parents.
void eraseEntities(Document& document, const std::vector<ObjectId>& ids);

/// The named entities and all below them, each once, parents before children, in the order of the file.
std::vector<ObjectId> withDescendants(const Document& document, const std::vector<ObjectId>& ids);

/// Those of `ids` that are not below another one of them: what has to be moved so that all move once.
std::vector<ObjectId> outermost(const Document& document, const std::vector<ObjectId>& ids);

/// Copies for pasting: new ids, references inside the group follow the copies, tiles are copied.
/// The first ones go behind everything else in the file.
std::vector<EntityState> copiesOf(Document& document, std::vector<EntityState> states);

}  // namespace plumb::editor
