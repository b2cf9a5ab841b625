#include "scene/files/scene_writer.hpp"

#include <algorithm>
#include <map>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "reflect/cbor.hpp"
#include "reflect/component_json.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab_placing.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb {

SceneWriter::SceneWriter(World& world, const SceneContext& context, const LoadedScene& scene)
    : world_{world}, context_{context}, scene_{scene}, fields_{world} {
    for (const TypeInfo& type : context.types.all()) {
        const bool ownKey = type.key == typeKey<SceneEntity>() || type.key == typeKey<Name>() ||
                            type.key == typeKey<PrefabInstance>() || type.key == typeKey<PrefabPart>();
        if (!ownKey) savedTypes_.push_back({&type, PrefabValue{type, nullptr, fields_}});
    }
}

std::vector<SceneWriter::Item> SceneWriter::itemsInOrder() const {
    std::vector<Item> items;
    for (auto [entity, source] :
         std::as_const(world_).query<const SceneEntity>(without<PrefabPart>, withPaused)) {
        if (source.scene == scene_.id) items.push_back({source.order, source.id, entity.id(), nullptr});
    }
    if (scene_.rest != nullptr) {
        for (const SkippedEntity& skipped : scene_.rest->skipped)
            items.push_back({skipped.place, 0, {}, &skipped});
    }
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
        return a.order != b.order ? a.order < b.order : a.id < b.id;
    });
    return items;
}

const KeptEntity* SceneWriter::keptOf(std::uint64_t id) const {
    if (scene_.rest == nullptr) return nullptr;
    const auto found = scene_.rest->entities.find(id);
    return found == scene_.rest->entities.end() ? nullptr : &found->second;
}

/// Adds kept values of the file that no component represents, if the field still has its loaded value.
void SceneWriter::addKeptFields(const TypeInfo& type, const void* object, const KeptEntity& kept,
                                Json& fields) const {
    for (const KeptField& item : kept.fields) {
        if (item.component != type.name) continue;
        const FieldInfo* field = type.find(item.key);
        const bool known = field != nullptr && !field->transient;
        if (!known || fieldToJson(*field, object, fields_) == item.loaded) fields[item.key] = item.raw;
    }
}

/// Adds the position even if it is the default, so that moving an entity changes only one line of the file.
void SceneWriter::addPosition(const TypeInfo& type, const void* transform, Json& fields) const {
    constexpr const char* kPosition = "position";
    if (fields.contains(kPosition)) return;
    Json placed = Json::object();
    placed[kPosition] = fieldToJson(*type.find(kPosition), transform, fields_);
    placed.update(fields);
    fields = std::move(placed);
}

Json SceneWriter::componentsOf(EntityId entity, const PrefabEntity* base, PartContext* parts,
                               const KeptEntity* kept) const {
    Json components = Json::object();
    auto& list = *components.get_ptr<Json::object_t*>();
    for (const SavedType& saved : savedTypes_) {
        const void* object = std::as_const(world_).find(*saved.type, entity);
        if (object == nullptr) continue;
        const std::string name{saved.type->name};
        const auto inPrefab = base == nullptr ? Json::const_iterator{} : base->components.find(name);
        const bool overrides = base != nullptr && inPrefab != base->components.end();
        Json fields = overrides ? componentToJson(*saved.type, object,
                                                  PrefabValue{*saved.type, &*inPrefab, *parts}.get(), fields_)
                                : componentToJson(*saved.type, object, saved.defaults.get(), fields_);
        if (kept != nullptr) addKeptFields(*saved.type, object, *kept, fields);
        if (saved.type->key == typeKey<Transform>() && !world_.has<PrefabPart>(entity))
            addPosition(*saved.type, object, fields);
        if (!overrides || !fields.empty()) list.emplace_back(name, std::move(fields));
    }

    if (kept != nullptr) {
        for (const auto& [name, value] : kept->components) components[name] = value;
    }
    return components;
}

Json SceneWriter::withoutList(EntityId entity, const PrefabEntity& base) const {
    Json without = Json::array();
    for (const SavedType& saved : savedTypes_) {
        if (base.components.contains(std::string{saved.type->name}) && !world_.has(*saved.type, entity)) {
            without.push_back(std::string{saved.type->name});
        }
    }
    return without;
}

PlacedPrefab SceneWriter::partsOf(EntityId root, std::uint64_t id, const Prefab& prefab) {
    if (partIndex_.empty()) {
        for (auto [entity, part] : std::as_const(world_).query<const PrefabPart>(withPaused)) {
            partIndex_.emplace(std::pair{part.instance, part.part}, entity.id());
        }
        partIndex_.emplace(std::pair{0, 0}, EntityId{});  // so that it is never empty once built
    }
    PlacedPrefab placed{{root}};
    for (std::size_t i = 1; i < prefab.entities.size(); ++i) {
        const auto found = partIndex_.find({id, prefab.entities[i].part});
        placed.entities.push_back(found == partIndex_.end() ? EntityId{} : found->second);
    }
    return placed;
}

void SceneWriter::addName(EntityId entity, std::string_view inPrefab, const KeptEntity* kept,
                          Json& json) const {
    const Name* name = std::as_const(world_).find<Name>(entity);
    const std::string_view text = name == nullptr ? std::string_view{} : world_.texts().find(name->text);
    if (text != inPrefab) json["name"] = std::string{text};
    if (kept == nullptr) return;
    for (const auto& [key, value] : kept->keys) {
        if (key == "name" && !json.contains("name")) json["name"] = value;
    }
}

Json SceneWriter::childrenOf(const Prefab& prefab, const PlacedPrefab& placed, PartContext& parts,
                             std::uint64_t id) const {
    Json children = Json::object();
    for (std::size_t i = 1; i < prefab.entities.size(); ++i) {
        const PrefabEntity& base = prefab.entities[i];
        const EntityId entity = placed.entities[i];
        Json overrides = Json::object();
        if (!world_.alive(entity)) {
            const EntityId parent = parts.entity(base.parent);
            if (base.parent != 0 && !world_.alive(parent)) continue;  // removed with its parent
            overrides["removed"] = true;
        } else {
            const KeptEntity* kept = keptOf(combinedId(id, base.part));
            addName(entity, base.name, kept, overrides);
            if (Json without = withoutList(entity, base); !without.empty())
                overrides["without"] = std::move(without);
            Json components = componentsOf(entity, &base, &parts, kept);
            if (!components.empty()) overrides["components"] = std::move(components);
            if (kept != nullptr) addKeptKeys(*kept, overrides);
        }
        if (!overrides.empty()) children[hexText(base.part)] = std::move(overrides);
    }
    if (const KeptEntity* kept = keptOf(id)) {
        for (const KeptField& item : kept->fields) {
            if (item.component.empty()) children[item.key] = item.raw;
        }
    }
    return children;
}

void SceneWriter::addKeptKeys(const KeptEntity& kept, Json& json) const {
    for (const auto& [key, value] : kept.keys) {
        if (!json.contains(key) || (key == "components" && json[key].empty())) json[key] = value;
    }
}

Json SceneWriter::entityToJson(const Item& item) {
    Json json = Json::object();
    json["id"] = hexText(item.id);
    const KeptEntity* kept = keptOf(item.id);
    const PrefabInstance* instance = std::as_const(world_).find<PrefabInstance>(item.entity);
    const Prefab* prefab = nullptr;
    if (instance != nullptr && context_.prefabs != nullptr) {
        if (const auto found = context_.prefabs->find(world_.texts().find(instance->prefab.path)))
            prefab = *found;
    }
    const PrefabEntity* base = prefab == nullptr ? nullptr : &prefab->entities.front();
    addName(item.entity, base == nullptr ? std::string_view{} : std::string_view{base->name}, kept, json);
    const EntityId parent = parentOf(std::as_const(world_), item.entity);
    if (const std::uint64_t parentId = fields_.stableId(parent); parentId != 0) {
        json["parent"] = hexText(parentId);
    } else if (kept != nullptr && !kept->parent.is_null()) {
        json["parent"] = kept->parent;
    }
    if (base == nullptr) {
        json["components"] = componentsOf(item.entity, nullptr, nullptr, kept);
    } else {
        json["prefab"] = prefab->path;
        const PlacedPrefab placed = partsOf(item.entity, item.id, *prefab);
        PartContext parts{world_, *prefab, placed};
        if (Json without = withoutList(item.entity, *base); !without.empty())
            json["without"] = std::move(without);
        Json components = componentsOf(item.entity, base, &parts, kept);
        if (!components.empty()) json["components"] = std::move(components);
        Json children = childrenOf(*prefab, placed, parts, item.id);
        if (!children.empty()) json["children"] = std::move(children);
    }
    if (kept != nullptr) addKeptKeys(*kept, json);
    return json;
}

Json SceneWriter::layersToJson() const {
    Json layers = Json::array();
    const SceneLayer defaults;
    for (const SceneLayer& layer : scene_.layers) {
        Json json = componentToJson(sceneLayerType(), &layer, &defaults, fields_);
        if (scene_.rest != nullptr) {
            for (const KeptField& item : scene_.rest->layers) {
                if (item.component != fields_.text(layer.name)) continue;
                const FieldInfo* field = sceneLayerType().find(item.key);
                if (item.key.empty()) {
                    if (json.empty()) json = item.raw;
                } else if (field == nullptr || fieldToJson(*field, &layer, fields_) == item.loaded) {
                    json[item.key] = item.raw;
                }
            }
        }
        layers.push_back(std::move(json));
    }
    return layers;
}

std::string SceneWriter::write() {
    Json head = Json::object();
    head["format"] = kSceneFormat;
    head["effects"] = scene_.effects;
    head["layers"] = layersToJson();
    if (scene_.rest != nullptr) {
        for (const auto& [key, value] : scene_.rest->keys) {
            if (key != "layers" || head["layers"].empty()) head[key] = value;
        }
    }
    std::string out;
    appendJson(out, head, 0);
    out.resize(out.size() - 2);  // remove the line end and the closing bracket
    out += ",\n  \"entities\": [";
    bool first = true;
    for (const Item& item : itemsInOrder()) {
        out += first ? "\n    " : ",\n    ";
        first = false;
        if (item.skipped != nullptr) {
            out += item.skipped->text;
        } else {
            appendJson(out, entityToJson(item), 4);
        }
    }
    out += first ? "]\n}\n" : "\n  ]\n}\n";
    return out;
}

}  // namespace plumb
