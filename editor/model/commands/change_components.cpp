#include "editor/model/commands/change_components.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "scene/components/name.hpp"

namespace plumb::editor {

void ChangeComponents::swapComponents(Document& document) {
    for (Change& change : changes_) {
        const EntityId entity = document.find(change.object);
        std::optional<ComponentState> now;
        if (document.world.has(type_, entity)) now = readComponent(document, type_, entity);
        const std::optional<ComponentState> next = std::exchange(change.state, std::move(now));
        if (next.has_value() != change.state.has_value() || type_.key == typeKey<Name>())
            ++document.treeRevision;
        if (next) {
            writeComponent(document, entity, *next);
        } else {
            document.world.remove(type_, entity);
        }
    }
}

bool ChangeComponents::absorb(const Command& next) {
    const auto* other = dynamic_cast<const ChangeComponents*>(&next);
    // This command keeps the components from before the gesture; the later ones are in the document.
    return other != nullptr && &other->type_ == &type_ && other->label_ == label_ &&
           std::equal(changes_.begin(), changes_.end(), other->changes_.begin(), other->changes_.end(),
                      [](const Change& a, const Change& b) { return a.object == b.object; });
}

bool ChangeComponents::changesNothing(const Document& document) const {
    return std::all_of(changes_.begin(), changes_.end(), [&](const Change& change) {
        const EntityId entity = document.find(change.object);
        if (!document.world.has(type_, entity)) return !change.state;
        return change.state && readComponent(document, type_, entity).bytes == change.state->bytes;
    });
}

std::unique_ptr<Command> addComponent(const Document& document, const std::vector<ObjectId>& objects,
                                      const TypeInfo& type) {
    std::vector<ChangeComponents::Change> changes;
    for (const ObjectId object : objects) {
        if (!document.world.has(type, document.find(object)))
            changes.push_back({object, defaultComponent(type)});
    }
    return std::make_unique<ChangeComponents>(format("add {}", type.name), type, std::move(changes));
}

std::unique_ptr<Command> removeComponent(const Document& document, const std::vector<ObjectId>& objects,
                                         const TypeInfo& type) {
    std::vector<ChangeComponents::Change> changes;
    for (const ObjectId object : objects) {
        if (document.world.has(type, document.find(object))) changes.push_back({object, std::nullopt});
    }
    return std::make_unique<ChangeComponents>(format("remove {}", type.name), type, std::move(changes));
}

std::unique_ptr<Command> renameEntity(Document& document, ObjectId object, std::string_view name) {
    const TypeInfo& type = document.types().of<Name>();
    std::optional<ComponentState> state;
    if (!name.empty()) {
        // The text store only grows, so adding a text to it needs no undo.
        const Name value{document.world.texts().add(name)};
        state = ComponentState{&type, FieldValue::of(value).bytes};
    }
    std::vector<ChangeComponents::Change> changes;
    changes.push_back({object, std::move(state)});
    return std::make_unique<ChangeComponents>(format("rename to \"{}\"", name), type, std::move(changes));
}

}  // namespace plumb::editor
