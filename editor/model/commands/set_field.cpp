#include "editor/model/commands/set_field.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"

namespace plumb::editor {

std::string SetField::label() const {
    const std::string what = format("{}.{}", type_.name, field_.name);
    return changes_.size() == 1 ? format("set {}", what)
                                : format("set {} of {} entities", what, changes_.size());
}

bool SetField::absorb(const Command& next) {
    const auto* other = dynamic_cast<const SetField*>(&next);
    // This command keeps the values from before the gesture; the later ones are in the document.
    return other != nullptr && &other->field_ == &field_ &&
           std::equal(changes_.begin(), changes_.end(), other->changes_.begin(), other->changes_.end(),
                      [](const Change& a, const Change& b) { return a.object == b.object; });
}

bool SetField::changesNothing(const Document& document) const {
    return std::all_of(changes_.begin(), changes_.end(), [&](const Change& change) {
        const void* component = document.world.find(type_, document.find(change.object));
        return component != nullptr && readField(document, field_, component) == change.value;
    });
}

void SetField::swapValues(Document& document) {
    for (Change& change : changes_) {
        void* component = document.world.find(type_, document.find(change.object));
        PLUMB_ASSERT(component != nullptr, "SetField: the entity lacks the component");
        const FieldValue next = std::exchange(change.value, readField(document, field_, component));
        writeField(document, field_, component, next);
    }
}

}  // namespace plumb::editor
