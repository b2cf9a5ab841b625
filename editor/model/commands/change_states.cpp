#include "editor/model/commands/change_states.hpp"

#include <algorithm>
#include <utility>

namespace plumb::editor {

void ChangeStates::swapStates(Document& document) {
    for (Change& change : changes_) {
        const EntityId entity = document.find(change.object);
        PLUMB_ASSERT(document.world.has(*change.state.type, entity),
                     "ChangeStates: the entity lacks the component");
        const ComponentState next =
            std::exchange(change.state, readComponent(document, *change.state.type, entity));
        writeComponent(document, entity, next);
    }
}

bool ChangeStates::absorb(const Command& next) {
    const auto* other = dynamic_cast<const ChangeStates*>(&next);
    // This command keeps the values from before the gesture; the later ones are in the document.
    return other != nullptr && other->label_ == label_ &&
           std::equal(changes_.begin(), changes_.end(), other->changes_.begin(), other->changes_.end(),
                      [](const Change& a, const Change& b) {
                          return a.object == b.object && a.state.type == b.state.type;
                      });
}

bool ChangeStates::changesNothing(const Document& document) const {
    return std::all_of(changes_.begin(), changes_.end(), [&](const Change& change) {
        const EntityId entity = document.find(change.object);
        return readComponent(document, *change.state.type, entity).bytes == change.state.bytes;
    });
}

}  // namespace plumb::editor
