#include "editor/model/clipboard.hpp"

#include <algorithm>
#include <map>

#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kMark = "plumbEntities";

ComponentState componentFrom(const TypeInfo& type, const Json& json, WorldFieldContext& context) {
    ComponentState state = defaultComponent(type);
    if (!json.is_object()) return state;
    for (const FieldInfo& field : type.fields) {
        const auto found = json.find(std::string{field.name});
        if (found == json.end()) continue;
        if (field.kind == FieldKind::Entity) {
            const ObjectId id{hexIdOf(*found)};
            std::memcpy(field.in(static_cast<void*>(state.bytes.data())), &id, sizeof id);
        } else if (!(field.kind == FieldKind::List && field.element == FieldKind::Entity)) {
            static_cast<void>(fieldFromJson(field, state.bytes.data(), *found, context).ok());
        }
    }
    return state;
}

EntityState entityFrom(const Document& document, const Json& json, WorldFieldContext& context) {
    EntityState state;
    state.id = {hexIdIn(json, "id")};
    state.parent = {hexIdIn(json, "parent")};
    SceneEntity part;
    state.components.push_back({&document.types().of<SceneEntity>(), FieldValue::of(part).bytes});
    const Json* components = findObject(json, "components");
    if (components == nullptr) return state;
    for (const auto& [name, fields] : components->items()) {
        const TypeInfo* type = document.types().find(name);
        if (type != nullptr && type->key != typeKey<SceneEntity>()) {
            state.components.push_back(componentFrom(*type, fields, context));
        }
    }
    return state;
}

template <class T>
const ComponentState* stateOf(const EntityState& state) {
    const auto found =
        std::find_if(state.components.begin(), state.components.end(),
                     [](const ComponentState& component) { return component.type->key == typeKey<T>(); });
    return found == state.components.end() ? nullptr : &*found;
}

template <class T>
void drop(EntityState& state) {
    std::erase_if(state.components,
                  [](const ComponentState& component) { return component.type->key == typeKey<T>(); });
}

std::string prefabOf(const Document& document, const EntityState& state) {
    const ComponentState* link = stateOf<PrefabInstance>(state);
    if (link == nullptr) return {};
    PrefabInstance instance;
    std::memcpy(&instance, link->bytes.data(), sizeof instance);
    return std::string{document.world.texts().find(instance.prefab.path)};
}

/// Returns the reason why these entities cannot be pasted into the open document, or an empty text.
std::string whyNotHere(const PrefabEdit& edit, const std::vector<EntityState>& states) {
    if (!prefabRootOf(edit.document)) return {};
    for (const EntityState& state : states) {
        const std::string path = prefabOf(edit.document, state);
        if (!path.empty() && isInside(edit.root, edit.document.scenePath, path))
            return format("{} cannot be pasted here: it is the edited prefab or contains it", path);
    }
    return {};
}

/// Turns instances and parts for which this project has no prefab into plain entities.
/// @return paths of the missing prefabs
std::vector<std::string> unpackStrangers(const PrefabEdit& edit, std::vector<EntityState>& states) {
    std::vector<std::string> missing;
    std::map<std::uint64_t, const Prefab*> instances;  // null: its prefab is missing
    for (EntityState& state : states) {
        const std::string path = prefabOf(edit.document, state);
        if (path.empty()) continue;
        const Prefab* prefab = nullptr;
        if (edit.prefabs != nullptr) {
            if (const Result<const Prefab*> found = edit.prefabs->find(path)) prefab = *found;
        }
        instances[state.id.value] = prefab;
        if (prefab != nullptr) continue;
        drop<PrefabInstance>(state);
        if (std::find(missing.begin(), missing.end(), path) == missing.end()) missing.push_back(path);
    }
    for (EntityState& state : states) {
        const ComponentState* link = stateOf<PrefabPart>(state);
        if (link == nullptr) continue;
        PrefabPart part;
        std::memcpy(&part, link->bytes.data(), sizeof part);
        const auto instance = instances.find(part.instance);
        if (instance == instances.end()) continue;  // without its instance, copiesOf makes it a plain entity
        if (instance->second == nullptr || instance->second->find(part.part) == nullptr)
            drop<PrefabPart>(state);
    }
    return missing;
}

}  // namespace

std::string copyAsText(Document& document, const std::vector<ObjectId>& objects) {
    WorldFieldContext context{document.world};
    Json list = Json::array();
    for (const ObjectId id : withDescendants(document, objects)) {
        const EntityState state = readEntity(document, id);
        Json components = Json::object();
        for (const ComponentState& component : state.components) {
            const TypeInfo& type = *component.type;
            if (type.key == typeKey<SceneEntity>()) continue;
            Json fields = Json::object();
            const void* object = document.world.find(type, document.find(id));
            for (const FieldInfo& field : type.fields) {
                fields[std::string{field.name}] = fieldToJson(field, object, context);
            }
            components[std::string{type.name}] = std::move(fields);
        }
        Json entity = Json::object();
        entity["id"] = hexText(id.value);
        if (state.parent) entity["parent"] = hexText(state.parent.value);
        entity["components"] = std::move(components);
        list.push_back(std::move(entity));
    }
    Json whole = Json::object();
    whole[std::string{kMark}] = std::move(list);
    return writeJson(whole);
}

Pasted pasteFromText(const PrefabEdit& edit, std::string_view text) {
    Document& document = edit.document;
    Pasted pasted;
    const Result<Json> json = parseJson(text, "clipboard");
    const Json* list = json ? findArray(*json, kMark) : nullptr;
    if (list == nullptr) return pasted;
    WorldFieldContext context{document.world};
    std::vector<EntityState> states;
    for (const Json& entity : *list) {
        if (entity.is_object()) states.push_back(entityFrom(document, entity, context));
    }
    if (states.empty()) return pasted;
    pasted.why = whyNotHere(edit, states);
    if (!pasted.why.empty()) return pasted;
    pasted.unpacked = unpackStrangers(edit, states);
    for (const std::string& path : pasted.unpacked)
        logWarning("Editor", Error{path, "the prefab is not in this project",
                                   "its instance was pasted as plain entities; copy the prefab's file here "
                                   "and paste again to keep it an instance"});
    const std::string label =
        states.size() == 1 ? "paste entity" : format("paste {} entities", states.size());
    for (const EntityState& state : states) pasted.originals.push_back(state.id);
    std::vector<EntityState> copies = copiesOf(document, std::move(states));
    belowPrefabRoot(document, copies);
    pasted.command = std::make_unique<InsertEntities>(label, std::move(copies));
    return pasted;
}

}  // namespace plumb::editor
