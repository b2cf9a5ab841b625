#include "editor/model/clipboard.hpp"

#include "core/text.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/world_field_context.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kMark = "plumbEntities";

ObjectId idFrom(const Json& json) {
    if (!json.is_string()) return {};
    return {parseHex(json.get_ref<const std::string&>()).value_or(0)};
}

ComponentState componentFrom(const TypeInfo& type, const Json& json, WorldFieldContext& context) {
    ComponentState state = defaultComponent(type);
    if (!json.is_object()) return state;
    for (const FieldInfo& field : type.fields) {
        const auto found = json.find(std::string{field.name});
        if (found == json.end()) continue;
        if (field.kind == FieldKind::Entity) {
            const ObjectId id = idFrom(*found);
            std::memcpy(field.in(static_cast<void*>(state.bytes.data())), &id, sizeof id);
        } else if (!(field.kind == FieldKind::List && field.element == FieldKind::Entity)) {
            static_cast<void>(fieldFromJson(field, state.bytes.data(), *found, context).ok());
        }
    }
    return state;
}

EntityState entityFrom(const Document& document, const Json& json, WorldFieldContext& context) {
    EntityState state;
    const Json none;
    const auto member = [&](const char* key) -> const Json& {
        const auto found = json.find(key);
        return found == json.end() ? none : *found;
    };
    state.id = idFrom(member("id"));
    state.parent = idFrom(member("parent"));
    SceneEntity part;
    state.components.push_back({&document.types().of<SceneEntity>(), FieldValue::of(part).bytes});
    for (const auto& [name, fields] : member("components").items()) {
        const TypeInfo* type = document.types().find(name);
        if (type != nullptr && type->key != typeKey<SceneEntity>()) {
            state.components.push_back(componentFrom(*type, fields, context));
        }
    }
    return state;
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

std::unique_ptr<InsertEntities> pasteFromText(Document& document, std::string_view text) {
    const Result<Json> json = parseJson(text, "clipboard");
    if (!json || !json->is_object() || !json->contains(std::string{kMark})) return nullptr;
    const Json& list = (*json)[std::string{kMark}];
    if (!list.is_array() || list.empty()) return nullptr;
    WorldFieldContext context{document.world};
    std::vector<EntityState> states;
    for (const Json& entity : list) {
        if (entity.is_object()) states.push_back(entityFrom(document, entity, context));
    }
    if (states.empty()) return nullptr;
    const std::string label =
        states.size() == 1 ? "paste entity" : format("paste {} entities", states.size());
    return std::make_unique<InsertEntities>(label, copiesOf(document, std::move(states)));
}

}  // namespace plumb::editor
