#include "editor/model/edit_fields.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/document/field_number.hpp"
#include "editor/model/document/root_place.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {
namespace {

const void* componentOf(const Workspace& workspace, const FieldTarget& target, ObjectId id) {
    return workspace.shownWorld().find(target.type, workspace.shownEntity(id));
}

/// Returns the component with the present position and rotation if the entity is the root of the open prefab,
/// which must not move.
ComponentState withRootPoseKept(const Document& document, ObjectId id, ComponentState state) {
    const World& world = document.world;
    const void* now = world.find(*state.type, document.find(id));
    for (const FieldInfo& field : state.type->fields) {
        if (now == nullptr || !isPlaceOfRoot(document, id, *state.type, field.name)) continue;
        std::memcpy(field.in(static_cast<void*>(state.bytes.data())), field.in(now), field.size);
    }
    return state;
}

}  // namespace

std::vector<FieldValue> readFields(const Workspace& workspace, const FieldTarget& target) {
    std::vector<FieldValue> values;
    for (const ObjectId id : target.objects) {
        if (const void* component = componentOf(workspace, target, id))
            values.push_back(readField(workspace.shownNames(), target.field, component));
    }
    return values;
}

void editFields(Workspace& workspace, const FieldTarget& target, const ChangeValue& change) {
    std::vector<SetField::Change> changes;
    bool differs = false;
    for (std::size_t i = 0; i < target.objects.size(); ++i) {
        const ObjectId id = target.objects[i];
        const void* component = componentOf(workspace, target, id);
        if (component == nullptr || isPlaceOfRoot(workspace.document, id, target.type, target.field.name))
            continue;
        const FieldValue now = readField(workspace.shownNames(), target.field, component);
        FieldValue next = now;
        change(next, i);
        if (!workspace.play.running()) {
            differs |= next != now;
            changes.push_back({id, std::move(next)});
        } else if (next != now) {
            workspace.play.edit(id, target.type, target.field, next);
        }
    }
    if (differs)
        workspace.undo.push(std::make_unique<SetField>(target.type, target.field, std::move(changes)));
}

void setComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const ComponentState& state,
                  std::string label) {
    if (!workspace.play.running()) {
        std::vector<ChangeComponents::Change> changes;
        for (const ObjectId id : ids)
            changes.push_back({id, withRootPoseKept(workspace.document, id, state)});
        return workspace.undo.push(
            std::make_unique<ChangeComponents>(std::move(label), *state.type, std::move(changes)));
    }
    for (const FieldInfo& field : state.type->fields) {
        if (field.transient) continue;
        const auto* from =
            static_cast<const std::byte*>(field.in(static_cast<const void*>(state.bytes.data())));
        const FieldValue value{{from, from + field.size}};
        editFields(workspace, {*state.type, field, ids}, [&](FieldValue& one, std::size_t) { one = value; });
    }
}

void resetComponent(Workspace& workspace, const std::vector<ObjectId>& ids, const TypeInfo& type) {
    setComponent(workspace, ids, defaultComponent(type), format("reset {}", type.name));
}

Result<Done> typeNumber(Workspace& workspace, const FieldTarget& target, std::size_t at,
                        std::string_view text) {
    std::vector<double> results(target.objects.size());
    for (std::size_t i = 0; i < target.objects.size(); ++i) {
        const void* component = componentOf(workspace, target, target.objects[i]);
        if (component == nullptr) continue;
        const FieldValue now = readField(workspace.shownNames(), target.field, component);
        const Result<double> result =
            typedNumber(text, {numberAt(target.field, now, at), i, target.objects.size()});
        if (!result) return result.error();
        results[i] = *result;
    }
    editFields(workspace, target,
               [&](FieldValue& value, std::size_t i) { setNumberAt(target.field, value, results[i], at); });
    return Done{};
}

}  // namespace plumb::editor
