#include "editor/model/commands/change_components.hpp"

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
        if (next) {
            writeComponent(document, entity, *next);
        } else {
            document.world.remove(type_, entity);
        }
    }
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
        // The text store only grows, so keeping the text is not a change that undo must know.
        const Name value{document.world.texts().add(name)};
        state = ComponentState{&type, FieldValue::of(value).bytes};
    }
    std::vector<ChangeComponents::Change> changes;
    changes.push_back({object, std::move(state)});
    return std::make_unique<ChangeComponents>(format("rename to \"{}\"", name), type, std::move(changes));
}

}  // namespace plumb::editor
