#include "editor/model/prefabs/override_list.hpp"

#include "core/text.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kLongest = 60;  // bytes: longer values are cut

std::string shortText(const Json& value) {
    std::string text{trimmed(writeJson(value))};  // the number format of scene files
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
}

/// Returns a field's value in the prefab: the one in the prefab's file, or the default.
std::string inPrefab(const PrefabEdit& edit, const InstancePart& part, const TypeInfo& type,
                     const std::string& name) {
    const Json& fields = part.base().components[std::string{type.name}];
    if (const auto found = fields.find(name); found != fields.end()) return shortText(*found);
    const FieldInfo* field = type.find(name);
    if (field == nullptr || type.size == 0) return {};
    const ComponentState fresh = defaultComponent(type);
    return shortText(fieldToJson(*field, fresh.bytes.data(), WorldFieldContext{edit.document.world}));
}

void addComponent(const PrefabEdit& edit, const InstancePart& part,
                  const PrefabOverrides::Component& component, std::vector<OverrideRow>& rows) {
    const std::string name = edit.document.nameOf(part.id());
    if (component.added || component.removed) {
        rows.push_back({part.id(),
                        component.type,
                        {},
                        name,
                        component.added ? "-" : "present",
                        component.added ? "added" : "removed"});
        return;
    }
    const Json here = part.differences(*component.type);
    for (const std::string& field : component.fields) {
        rows.push_back({part.id(), component.type, field, name, inPrefab(edit, part, *component.type, field),
                        shortText(here[field])});
    }
}

}  // namespace

std::vector<OverrideRow> overrideList(const PrefabEdit& edit, ObjectId id) {
    std::vector<OverrideRow> rows;
    const auto instance = InstancePart::of(edit.document, edit.prefabs, id);
    if (!instance) return rows;
    for (const ObjectId member : instance->all()) {
        const auto part = InstancePart::of(edit.document, edit.prefabs, member);
        if (!part) continue;
        const PrefabOverrides overrides = overridesOf(edit.document, edit.prefabs, member);
        for (const PrefabOverrides::Component& component : overrides.components) {
            addComponent(edit, *part, component, rows);
        }
    }
    for (const EntityState& gone : missingParts(edit.document, instance->prefab(), instance->root())) {
        for (const PrefabEntity& entity : instance->prefab().entities) {
            if (combinedId(instance->root().value, entity.part) != gone.id.value) continue;
            rows.push_back({gone.id, nullptr, {}, entity.name, "present", "removed"});
        }
    }
    return rows;
}

bool revertOverride(const PrefabEdit& edit, const OverrideRow& row) {
    if (row.type != nullptr) return revertToPrefab(edit, {row.object}, row.scope());
    return restorePart(edit, row.object);
}

}  // namespace plumb::editor
