#include "editor/model/commands/reparent.hpp"

#include <utility>

#include "ecs/hierarchy.hpp"
#include "editor/model/document.hpp"

namespace plumb::editor {

Reparent::Reparent(std::vector<ObjectId> objects, ObjectId parent) : parent_{parent} {
    for (const ObjectId object : objects) {
        changes_.push_back({object, parent});
    }
}

void Reparent::swapParents(Document& document) {
    for (Change& change : changes_) {
        const EntityId entity = document.find(change.object);
        const ObjectId before = document.idOf(parentOf(std::as_const(document.world), entity));
        // Refused when it would close a circle; then taking it back changes nothing either.
        setParent(document.world, entity, document.find(change.parent));
        change.parent = before;
    }
}

}  // namespace plumb::editor
