#include "editor/model/play/keep_changes.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/cost/scene_physics_edit.hpp"
#include "editor/model/document/undo_stack.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb::editor {
namespace {

bool holdsText(FieldKind kind) { return kind == FieldKind::Text || kind == FieldKind::Asset; }

/// Adds the texts that `value` refers to by id to the document's world.
void takeTexts(World& to, const World& from, const FieldInfo& field, FieldValue value) {
    const bool list = field.kind == FieldKind::List && holdsText(field.element);
    if (!list && !holdsText(field.kind)) return;
    const std::size_t count = list ? field.countOf(value.bytes.data()) : 1;
    for (std::size_t i = 0; i < count; ++i) {
        TextId id;
        std::memcpy(&id, &value.bytes[i * sizeof id], sizeof id);
        to.texts().add(from.texts().find(id));
    }
}

/// The value of a field as JSON text, as it is written to the scene file.
std::string textOf(Document& document, const PlayEdit& edit, const FieldValue& value) {
    ComponentState scratch = defaultComponent(*edit.type);
    writeField(document, *edit.field, scratch.bytes.data(), value);
    const WorldFieldContext context{document.world};
    std::string text;
    appendJson(text, fieldToJson(*edit.field, scratch.bytes.data(), context), 0);
    return text;
}

/// True if the scene has the edited entity and its component, or the component can be added automatically.
bool canKeep(const Document& document, const PlayEdit& edit) {
    const EntityId entity = document.find(edit.object);
    return entity && (document.world.has(*edit.type, entity) || isAddedOnEdit(*edit.type));
}

/// Returns the field's value in the scene; the default value if the entity does not have the component.
FieldValue valueNow(const Document& document, const PlayEdit& edit) {
    const void* component = document.world.find(*edit.type, document.find(edit.object));
    if (component != nullptr) return readField(document, *edit.field, component);
    const ComponentState fresh = defaultComponent(*edit.type);
    return readField(document, *edit.field, fresh.bytes.data());
}

}  // namespace

std::vector<KeepRow> changesToKeep(Document& document, const World& played, const PlayEdits& edits) {
    std::vector<KeepRow> rows;
    for (const PlayEdit& edit : edits.last()) {
        if (edit.field->transient || !canKeep(document, edit)) continue;
        const FieldValue now = valueNow(document, edit);
        if (now == edit.value) continue;
        takeTexts(document.world, played, *edit.field, edit.value);
        rows.push_back({edit, document.nameOf(edit.object),
                        format("{}.{}", edit.type->name, edit.field->name), textOf(document, edit, now),
                        textOf(document, edit, edit.value), !edit.rewound});
    }
    return rows;
}

std::size_t keepChanges(Document& document, UndoStack& undo, std::span<const KeepRow> rows) {
    const auto takes = [&document](const KeepRow& row) { return row.keep && canKeep(document, row.edit); };
    const auto count = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), takes));
    Transaction step{undo,
                     count == 1 ? "keep a change of the game" : format("keep {} changes of the game", count)};
    for (const KeepRow& row : rows) {
        if (!takes(row)) continue;
        if (!document.world.has(*row.edit.type, document.find(row.edit.object)))
            undo.push(addComponent(document, {row.edit.object}, *row.edit.type));
        std::vector<SetField::Change> change;
        change.push_back({row.edit.object, row.edit.value});
        undo.push(std::make_unique<SetField>(*row.edit.type, *row.edit.field, std::move(change)));
    }
    step.commit();
    return count;
}

}  // namespace plumb::editor
