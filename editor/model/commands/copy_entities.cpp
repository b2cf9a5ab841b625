#include "editor/model/commands/copy_entities.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/place_copies.hpp"

namespace plumb::editor {

std::string CopyEntities::label() const {
    return originals_.size() == 1 ? "drag a copy" : format("drag copies of {} entities", originals_.size());
}

std::vector<ObjectId> CopyEntities::ids() const {
    std::vector<ObjectId> ids;
    for (const EntityState& copy : copies_) ids.push_back(copy.id);
    return ids;
}

void CopyEntities::apply(Document& document) {
    if (copies_.empty()) {
        std::vector<EntityState> states;
        sources_ = withDescendants(document, originals_);
        for (const ObjectId id : sources_) states.push_back(readEntity(document, id));
        copies_ = copiesOf(document, std::move(states));
    }
    insertEntities(document, copies_);
    placeCopies(document, ids(), sources_);
    document.selection.set(outermost(document, ids()));
}

void CopyEntities::revert(Document& document) {
    placeAtEnd(document, ids());
    if (std::exchange(changed_, false)) {
        for (EntityState& copy : copies_) copy = readEntity(document, copy.id);
    }
    eraseEntities(document, ids());
}

bool CopyEntities::absorb(const Command& next) {
    const auto* change = dynamic_cast<const ChangeComponents*>(&next);
    if (change == nullptr) return false;
    const std::vector<ObjectId> mine = ids();
    const bool ofMine = std::all_of(change->changes().begin(), change->changes().end(), [&](const auto& one) {
        return std::find(mine.begin(), mine.end(), one.object) != mine.end();
    });
    changed_ = changed_ || ofMine;
    return ofMine;
}

}  // namespace plumb::editor
