#include "scene/files/scene_reader.hpp"

#include <algorithm>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/transform.hpp"
#include "scene/effect_table.hpp"
#include "scene/files/entity_keys.hpp"
#include "scene/files/scene_assets.hpp"

namespace plumb {
namespace {

/// True for keys that the engine does not read but that are valid.
bool isNote(std::string_view key) {
    return key == "background" || key == kPrefabFileNote || isEntityNote(key);
}

/// Returns the text of an entity to keep: from the file, or written from the JSON of a binary file.
std::string keptText(std::string_view text, const Json& json) {
    if (!text.empty()) return std::string{text};
    std::string written;
    appendJson(written, json, 4);
    return written;
}

/// Returns the field name at the start of a path: "cells" for "cells[3].x".
std::string fieldName(const std::string& where) { return where.substr(0, where.find_first_of(".[")); }

}  // namespace

const TypeInfo& sceneLayerType() {
    static const TypeInfo kType = [] {
        TypeInfo type;
        TypeBuilder<SceneLayer> builder{type};
        SceneLayer::describe(builder);
        return type;
    }();
    return kType;
}

EntityId ReadingContext::entity(std::uint64_t stableId) const {
    const auto found = known_.find(stableId);
    if (found != known_.end()) return found->second;
    missed = true;
    return {};
}

SceneReader::SceneReader(World& world, const SceneContext& context, std::string_view path)
    : world_{world}, context_{context}, fields_{world} {
    scene_.path = path;
    scene_.id = {world.texts().add(path)};
    report_.scene = scene_.id;
}

void SceneReader::problem(std::string where, std::string what, std::string remedy) {
    report_.problems.push_back({format("{}: {}", scene_.path, where), std::move(what), std::move(remedy)});
}

void SceneReader::keepKey(std::string key, Json value) {
    if (key == "background") readBackground(value);
    if (!isNote(key)) {
        problem(key, "a scene has no such key", "it is kept unchanged; check the spelling or remove it");
    }
    rest_.keys.emplace_back(std::move(key), std::move(value));
}

void SceneReader::readBackground(const Json& json) {
    const auto* text = json.get_ptr<const std::string*>();
    const std::string_view digits =
        text != nullptr && startsWith(*text, "#") ? std::string_view{*text}.substr(1) : "";
    const std::optional<std::uint64_t> bits = parseHex(digits);
    if (!bits || digits.size() != 6) {
        problem("background", "expected a color, found " + foundText(json), "write it as \"#rrggbb\"");
        return;
    }
    const auto part = [&](int shift) { return static_cast<std::uint8_t>(*bits >> shift & 255); };
    scene_.background = {part(16), part(8), part(0), 255};
}

void SceneReader::reserve(std::size_t entities) { fields_.reserve(entities); }

void SceneReader::readEffects(const Json& json) {
    scene_.effects = json;
    if (!json.is_object())
        problem("effects", "expected an object, found " + foundText(json), "write {} for none");
}

void SceneReader::readLayers(const Json& json) {
    if (!json.is_array()) {
        problem("layers", "expected a list, found " + foundText(json), "write [] for none");
        rest_.keys.emplace_back("layers", json);
        return;
    }
    for (std::size_t i = 0; i < json.size(); ++i) {
        const std::string where = format("layers[{}]", i);
        SceneLayer layer;
        fieldProblems_.clear();
        componentFromJson(sceneLayerType(), &layer, json[i], fields_, fieldProblems_);
        const std::string name{fields_.text(layer.name)};
        for (FieldProblem& found : fieldProblems_) {
            problem(format("{}.{}", where, found.key), found.error.what, found.error.remedy);
            const FieldInfo* field = sceneLayerType().find(found.key);
            rest_.layers.push_back({name, found.key, found.key.empty() ? json[i] : json[i][found.key],
                                    field == nullptr ? Json() : fieldToJson(*field, &layer, fields_)});
        }
        for (Error& warning : fields_.warnings) {
            const std::string key = fieldName(warning.where);
            problem(format("{}.{}", where, warning.where), warning.what, warning.remedy);
            rest_.layers.push_back(
                {name, key, json[i][key], fieldToJson(*sceneLayerType().find(key), &layer, fields_)});
        }
        fields_.warnings.clear();
        scene_.layers.push_back(layer);
    }
}

void SceneReader::skipEntity(int place, std::string_view text, Error error) {
    error.remedy += error.remedy.empty() ? "the entity was skipped" : " (the entity was skipped)";
    report_.problems.push_back(std::move(error));
    rest_.skipped.push_back({place, std::string{text}});
    ++report_.skipped;
}

bool SceneReader::readId(const Json& json, int place, std::string_view text, std::uint64_t& id) {
    const std::string where = format("{}: entities[{}].id", scene_.path, place);
    const auto found = json.find("id");
    if (found == json.end()) {
        id = mixBits(scene_.id.path.value + static_cast<std::uint64_t>(place)) | 1u;
        problem(format("entities[{}]", place), "the entity has no id",
                format("the id \"{}\" was assigned; save the scene to keep it", hexText(id)));
        return true;
    }
    id = hexIdOf(*found);
    if (id == 0) {
        skipEntity(
            place, keptText(text, json),
            {where, "expected 16 hex digits, found " + foundText(*found), "write e.g. \"9f3c1a77d2e0b154\""});
    }
    return id != 0;
}

void SceneReader::readEntity(Json json, int place, std::string_view text) {
    const std::string where = format("entities[{}]", place);
    if (!json.is_object()) {
        return skipEntity(
            place, keptText(text, json),
            {format("{}: {}", scene_.path, where), "expected an object, found " + foundText(json),
             "write {\"id\": ..., \"components\": {...}}"});
    }
    if (fileFormat < kSceneFormat) migrateEntity(json, fileFormat);
    std::uint64_t id = 0;
    if (!readId(json, place, text, id)) return;
    fields_.missed = false;
    if (fields_.entity(id)) {
        return skipEntity(
            place, keptText(text, json),
            {format("{}: {}.id", scene_.path, where), format("another entity has the id \"{}\"", hexText(id)),
             "give one of the two a new id"});
    }
    EntityId entity;
    if (json.contains("prefab")) {
        if (!placeInstance(json, place, text, id, entity)) return;
    } else {
        entity = world_.createEntity();
        fields_.insert(id, entity);
    }
    world_.add<SceneEntity>(entity, SceneEntity{id, place, scene_.id});
    readKeys(json, entity, id, where);
    ++report_.loaded;
}

bool SceneReader::placeInstance(const Json& json, int place, std::string_view text, std::uint64_t id,
                                EntityId& entity) {
    const std::string where = format("{}: entities[{}].prefab", scene_.path, place);
    const auto* path = json["prefab"].get_ptr<const std::string*>();
    if (path == nullptr || context_.prefabs == nullptr) {
        skipEntity(place, keptText(text, json),
                   {where, "expected the path of a prefab, found " + foundText(json["prefab"]),
                    "write e.g. \"prefabs/coin.prefab.json\""});
        skippedIds_.push_back(id);
        return false;
    }
    const Result<const Prefab*> prefab = context_.prefabs->find(*path);
    if (!prefab) {
        skipEntity(place, keptText(text, json),
                   {where, prefab.error().where + ": " + prefab.error().what, prefab.error().remedy});
        skippedIds_.push_back(id);
        return false;
    }
    const Prefab& source = **prefab;
    const PlacedPrefab placed = placePrefab(world_, context_.types, source);
    entity = placed.entities.front();
    for (std::size_t i = 0; i < placed.entities.size(); ++i) {
        const std::uint64_t part = source.entities[i].part;
        fields_.insert(combinedId(id, part), placed.entities[i]);
        if (i == 0) continue;
        world_.add<PrefabPart>(placed.entities[i], PrefabPart{id, part});
        world_.add<SceneEntity>(placed.entities[i], SceneEntity{combinedId(id, part), place, scene_.id});
    }
    world_.add<PrefabInstance>(entity, PrefabInstance{{world_.texts().add(*path)}});
    return true;
}

void SceneReader::readKeys(const Json& json, EntityId entity, std::uint64_t id, const std::string& where) {
    const bool isInstance = json.contains("prefab");
    for (const auto& [key, value] : *json.get_ptr<const Json::object_t*>()) {
        if (key == "id" || key == "prefab") continue;
        if (key == "name") {
            readName(value, entity, id, where);
        } else if (key == "parent") {
            parents_.push_back({entity, id, value, where + ".parent"});
        } else if (key == "without" && isInstance) {
            readWithout(value, entity, id, where);
        } else if (key == "components") {
            readComponents(value, entity, id, where + ".");
        } else if (key != "children" || !isInstance) {
            if (!isNote(key)) {
                problem(where + "." + key, "an entity has no such key",
                        "it is kept unchanged; check the spelling or remove it");
            }
            kept(id).keys.emplace_back(key, value);
        }
    }
    if (const auto children = json.find("children"); isInstance && children != json.end()) {
        readChildren(*children, entity, id, where + ".children");
    }
}

void SceneReader::readName(const Json& value, EntityId entity, std::uint64_t id, const std::string& where) {
    const auto* text = value.get_ptr<const std::string*>();
    if (text != nullptr) {
        world_.add<Name>(entity).text = world_.texts().add(*text);
        return;
    }
    problem(where + ".name", "expected a string, found " + foundText(value), "write it in double quotes");
    kept(id).keys.emplace_back("name", value);
}

void SceneReader::readWithout(const Json& value, EntityId entity, std::uint64_t id,
                              const std::string& where) {
    if (!value.is_array()) {
        problem(where + ".without", "expected a list, found " + foundText(value), "write e.g. [\"Sprite\"]");
        kept(id).keys.emplace_back("without", value);
        return;
    }
    for (const Json& item : value) {
        const TypeInfo* type =
            item.is_string() ? context_.types.find(*item.get_ptr<const std::string*>()) : nullptr;
        if (type != nullptr) {
            world_.remove(*type, entity);
        } else {
            problem(where + ".without", format("{} is not a component", foundText(item)),
                    "remove it from the list");
        }
    }
}

void SceneReader::readChildren(const Json& value, EntityId root, std::uint64_t id, const std::string& where) {
    if (!value.is_object()) {
        problem(where, "expected an object, found " + foundText(value),
                "write {\"<part>\": {\"components\": {...}}}");
        kept(id).keys.emplace_back("children", value);
        return;
    }
    for (const auto& [key, overrides] : value.items()) {
        const std::uint64_t part = parseHex(key).value_or(0);
        const std::uint64_t partId = combinedId(id, part);
        const EntityId entity = part <= Prefab::kRootPart ? EntityId{} : fields_.entity(partId);
        const bool isPart = entity && entity != root;
        if (!isPart || !overrides.is_object()) {
            problem(
                format("{}.{}", where, key),
                isPart ? "expected an object, found " + foundText(overrides) : "the prefab has no such part",
                "it is kept unchanged; remove it");
            kept(id).fields.push_back({"", key, overrides, Json()});
            continue;
        }
        if (!keepsPart(overrides, entity, partId, format("{}.{}.removed", where, key))) continue;
        readKeys(
            [&said = overrides] {
                Json copy = said;
                copy["prefab"] = "";  // so that readKeys() accepts the override keys of prefab instances
                copy.erase("children");
                copy.erase("removed");
                return copy;
            }(),
            entity, partId, format("{}.{}", where, key));
    }
}

bool SceneReader::keepsPart(const Json& overrides, EntityId entity, std::uint64_t id,
                            const std::string& where) {
    const Json* removed = findMember(overrides, "removed");
    if (removed == nullptr) return true;
    if (*removed == true) {
        world_.destroy(entity);
        return false;
    }
    if (!removed->is_boolean())
        problem(where, "expected true or false, found " + foundText(*removed),
                "it is kept unchanged, and the part is created; write true to remove it");
    kept(id).keys.emplace_back("removed", *removed);
    return true;
}

void SceneReader::readComponents(const Json& value, EntityId entity, std::uint64_t id,
                                 const std::string& where) {
    if (!value.is_object()) {
        problem(where + "components", "expected an object, found " + foundText(value), "write {} for none");
        kept(id).keys.emplace_back("components", value);
        return;
    }
    for (const auto& [name, fields] : *value.get_ptr<const Json::object_t*>()) {
        if (const TypeInfo* type = componentOfFiles(context_.types, name)) {
            readComponent(*type, fields, entity, id, where, true);
            continue;
        }
        const Error error = unknownComponent(context_.types, where + name, name);
        problem(error.where, error.what, error.remedy);
        kept(id).components.emplace_back(name, fields);
    }
}

void SceneReader::readComponent(const TypeInfo& type, const Json& json, EntityId entity, std::uint64_t id,
                                const std::string& where, bool mayWait) {
    if (!json.is_object()) {
        problem(where + std::string{type.name}, "expected an object, found " + foundText(json),
                "write {} for the defaults");
        kept(id).components.emplace_back(std::string{type.name}, json);
        return;
    }
    void* object = world_.has(type, entity) ? world_.find(type, entity) : world_.add(type, entity);
    fieldProblems_.clear();
    fields_.missed = false;
    componentFromJson(type, object, json, fields_, fieldProblems_);
    if (fields_.missed && mayWait) {
        fields_.warnings.clear();
        deferred_.push_back({entity, &type, json, where, id});
        return;
    }
    for (FieldProblem& found : fieldProblems_) {
        keepField(type, found.key, json, object, id);
        problem(where + found.error.where, found.error.what, found.error.remedy);
    }
    for (Error& warning : fields_.warnings) {
        keepField(type, fieldName(warning.where), json, object, id);
        problem(where + std::string{type.name} + "." + warning.where, warning.what, warning.remedy);
    }
    fields_.warnings.clear();
}

void SceneReader::keepField(const TypeInfo& type, const std::string& key, const Json& json,
                            const void* object, std::uint64_t id) {
    const FieldInfo* field = type.find(key);
    const auto raw = json.find(key);
    if (raw == json.end()) return;
    kept(id).fields.push_back(
        {std::string{type.name}, key, *raw,
         field == nullptr || field->transient ? Json() : fieldToJson(*field, object, fields_)});
}

/// Checks the effects of the scene if the world has an effect table.
void SceneReader::checkEffects() {
    const auto* table = world_.service<const EffectTable>();
    if (table == nullptr || scene_.effects.empty()) return;
    const std::vector<Pin> pins = table->readPins(scene_.effects, scene_.path, &report_.problems);
    table->checkNeeds(world_, scene_.id, scene_.path, pins, report_.problems);
}

/// Reads the prefabs that components name, so that their problems are reported now and not when the first of
/// them is spawned.
void SceneReader::readNamedPrefabs() {
    if (context_.prefabs == nullptr) return;
    std::vector<std::string> paths;
    for (const AssetName& name : namedAssets(world_, context_.types, AssetKind::Prefab))
        paths.emplace_back(world_.texts().find(name.path));
    static_cast<void>(context_.prefabs->readAll(std::move(paths)));
    for (Error& problem : context_.prefabs->takeProblems()) report_.problems.push_back(std::move(problem));
}

LoadReport SceneReader::finish() {
    for (const DeferredComponent& item : deferred_) {
        if (world_.alive(item.entity))
            readComponent(*item.type, item.json, item.entity, item.id, item.where, false);
    }
    for (const ParentLink& link : parents_) {
        const std::uint64_t id = hexIdOf(link.parent);
        const EntityId parent = id == 0 ? EntityId{} : fields_.entity(id);
        if (parent && setParent(world_, link.child, parent)) continue;
        kept(link.id).parent = link.parent;
        const bool skipped = std::find(skippedIds_.begin(), skippedIds_.end(), id) != skippedIds_.end();
        if (skipped) continue;  // already reported
        parent ? problem(link.where, "the parents form a cycle",
                         "change the parent of one of them; this entity has no parent now")
               : problem(link.where, format("no entity has the id {}", foundText(link.parent)),
                         "write the id of an entity of this file; the entity has no parent now");
    }
    for (auto [entity, source, transform] : world_.query<const SceneEntity, Transform>()) {
        if (source.scene != scene_.id) continue;
        transform.previousPosition = transform.position;
        transform.previousRotation = transform.rotation;
        transform.previousScale = transform.scale;
    }
    checkEffects();
    readNamedPrefabs();
    LoadedScenes& scenes = world_.resource<LoadedScenes>();
    scene_.rest = std::make_shared<const SceneRest>(std::move(rest_));
    scenes.add(std::move(scene_));
    return std::move(report_);
}

}  // namespace plumb
