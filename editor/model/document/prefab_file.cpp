#include "editor/model/document/prefab_file.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "assets/asset_store.hpp"
#include "core/guarded.hpp"
#include "core/text.hpp"
#include "editor/model/document/field_value.hpp"
#include "editor/model/document/prefab_instance.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_reader.hpp"
#include "scene/files/world_field_context.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb::editor {
namespace {

// Members of the note (kPrefabFileNote), which records how the file was written, so that saving reproduces
// it. "id" is the id of the root in the file.
constexpr const char* kId = "id";
constexpr const char* kOwnPlace = "ownPlace";    // fields of the root's Transform that the file contains
constexpr const char* kNoParent = "noParent";    // ids of entities without "parent", which means the root
constexpr const char* kNoLocation = "noPlace";   // ids of entities whose Transform has no "position"
constexpr const char* kRecord = "said";          // by entity: components and fields in file order
constexpr const char* kNoSceneKeys = "noScene";  // keys of scene files that the file lacks

const std::string& rootText() {
    static const std::string kText = hexText(Prefab::kRootPart);
    return kText;
}

Json* transformOf(Json& entity) {
    Json* components = findObject(entity, "components");
    return components == nullptr ? nullptr : findObject(*components, "Transform");
}

bool lists(const Json& note, const char* key, const Json& value) {
    const Json* list = findArray(note, key);
    return list != nullptr && std::find(list->begin(), list->end(), value) != list->end();
}

/// Returns the object with the key as its first member.
Json withFront(const char* key, Json value, const Json& object) {
    Json made = Json::object();
    made[key] = std::move(value);
    for (const auto& [name, member] : object.items()) {
        if (name != key) made[name] = member;
    }
    return made;
}

/// Replaces the id `from` by `to` in the references of an entity's components and of the overrides of its
/// parts.
void changeId(const TypeRegistry& types, Json& entity, std::uint64_t from, std::uint64_t to) {
    if (from == to) return;
    const auto change = [&](std::uint64_t id) { return id == from ? to : id; };
    if (Json* components = findObject(entity, "components")) changeReferences(types, *components, change);
    Json* children = findObject(entity, "children");
    if (children == nullptr) return;
    for (auto& [part, overrides] : children->items()) {
        if (Json* components = overrides.is_object() ? findObject(overrides, "components") : nullptr)
            changeReferences(types, *components, change);
    }
}

/// Records what writing a scene would lose of an entity's components: the order of components and fields, and
/// fields with default values (other fields are null).
Json recordOf(World& world, const TypeRegistry& types, const Json& entity) {
    Json record = Json::object();
    const Json* components = findObject(entity, "components");
    if (components == nullptr) return record;
    const WorldFieldContext context{world};
    for (const auto& [name, fields] : components->items()) {
        Json& keys = record[name] = Json::object();
        const TypeInfo* type = types.find(name);
        if (type == nullptr || type->size == 0 || !fields.is_object()) continue;
        const ComponentState fresh = defaultComponent(*type);
        for (const auto& [key, value] : fields.items()) {
            const FieldInfo* field = type->find(key);
            const bool isDefault = field != nullptr && !field->transient && !entity.contains("prefab") &&
                                   fieldToJson(*field, fresh.bytes.data(), context) == value;
            keys[key] = isDefault ? value : Json();
        }
    }
    return record;
}

/// Returns the members of `now` in the recorded order, new ones last.
/// @param add  also add recorded default values that `now` lacks
Json inOrderOf(const Json& record, const Json& now, bool add) {
    Json made = Json::object();
    for (const auto& [key, value] : record.items()) {
        if (const auto found = now.find(key); found != now.end()) {
            made[key] = *found;
        } else if (add && !value.is_null()) {
            made[key] = value;
        }
    }
    for (const auto& [key, value] : now.items()) made[key] = value;
    return made;
}

/// Converts a prefab file to a scene.
class SceneOfPrefab {
public:
    SceneOfPrefab(World& world, const TypeRegistry& types) : world_{world}, types_{types} {}

    /// @pre  the file is an object with an array "entities"
    Json make(const Json& file) {
        for (const char* key : {"effects", "layers"}) {
            if (!file.contains(key)) note_[kNoSceneKeys].push_back(key);
        }
        Json entities = Json::array();
        for (const Json& entity : file["entities"]) {
            entities.push_back(entity.is_object() ? made(entity, entities.empty()) : entity);
        }
        Json scene = Json::object();
        scene["format"] = kSceneFormat;
        scene[std::string{kPrefabFileNote}] = note_;
        for (const auto& [key, value] : file.items()) {
            if (key != "format" && key != "entities") scene[key] = value;
        }
        scene["entities"] = std::move(entities);
        return scene;
    }

private:
    Json made(Json entity, bool isRoot) {
        if (isRoot) {
            if (const auto id = entity.find("id"); id != entity.end()) note_[kId] = *id;
            rootId_ = hexIdIn(entity, "id") == 0 ? Prefab::kRootPart : hexIdIn(entity, "id");
            note_[kRecord][rootText()] = recordOf(world_, types_, entity);
            entity = withFront("id", rootText(), entity);
            entity.erase("parent");
            if (const Json* transform = transformOf(entity)) {
                for (const char* field : {"position", "rotation"}) {
                    if (transform->contains(field)) note_[kOwnPlace].push_back(field);
                }
            }
        } else {
            const Json* found = findMember(entity, "id");
            const Json id = found == nullptr ? Json() : *found;
            if (const std::string* text = jsonText(id))
                note_[kRecord][*text] = recordOf(world_, types_, entity);
            if (!entity.contains("parent")) note_[kNoParent].push_back(id);
            if (!entity.contains("parent") || hexIdIn(entity, "parent") == rootId_)
                entity["parent"] = rootText();
            const Json* transform = transformOf(entity);
            if (transform == nullptr || !transform->contains("position")) note_[kNoLocation].push_back(id);
        }
        changeId(types_, entity, rootId_, Prefab::kRootPart);
        return entity;
    }

    World& world_;
    const TypeRegistry& types_;
    Json note_ = Json::object();
    std::uint64_t rootId_ = Prefab::kRootPart;
};

/// Converts a scene to a prefab file.
class PrefabOfScene {
public:
    PrefabOfScene(const World& world, const TypeRegistry& types) : types_{types} {
        world.each<const PrefabPart>(
            [&](const PrefabPart& part) { owners_[combinedId(part.instance, part.part)] = part.instance; });
    }

    Json make(Json scene) {
        if (const Json* note = findObject(scene, kPrefabFileNote)) note_ = *note;
        rootId_ = hexIdIn(note_, kId) == 0 ? Prefab::kRootPart : hexIdIn(note_, kId);
        Json file = Json::object();
        file["format"] = Prefab::kFormat;
        for (const auto& [key, value] : scene.items()) {
            const bool own = key == "format" || key == "entities" || key == kPrefabFileNote;
            const bool ofScenes = value.empty() && (note_.empty() || lists(note_, kNoSceneKeys, key));
            if (!own && !ofScenes) file[key] = value;
        }
        Json& entities = scene["entities"];
        for (std::size_t i = 0; i < entities.size(); ++i) places_[hexIdIn(entities[i], "id")] = i;
        putWithId(entities, Prefab::kRootPart);
        for (std::size_t i = 0; i < entities.size(); ++i) put(entities, i);
        file["entities"] = std::move(made_);
        return file;
    }

private:
    /// Writes the entity with this id, and before it its parents, as the prefab format requires.
    void putWithId(Json& entities, std::uint64_t id) {
        if (const auto owner = owners_.find(id); owner != owners_.end()) id = owner->second;
        if (const auto place = places_.find(id); place != places_.end()) put(entities, place->second);
    }
    void put(Json& entities, std::size_t place) {
        if (!done_.insert(place).second) return;
        Json& entity = entities[place];
        if (!entity.is_object()) return made_.push_back(entity);
        if (const std::uint64_t parent = hexIdIn(entity, "parent")) putWithId(entities, parent);
        made_.push_back(made(entity));
    }

    [[nodiscard]] Json made(Json entity) const {
        const std::uint64_t id = hexIdIn(entity, "id");
        changeId(types_, entity, Prefab::kRootPart, rootId_);
        const Json* found = findMember(entity, "id");
        const Json idText = found == nullptr ? Json() : *found;
        if (id == Prefab::kRootPart) {
            if (note_.contains(kId)) {
                entity["id"] = note_[kId];
            } else if (!note_.empty()) {
                entity.erase("id");
            }
        } else if (hexIdIn(entity, "parent") == Prefab::kRootPart || !entity.contains("parent")) {
            entity["parent"] = hexText(rootId_);
            if (lists(note_, kNoParent, idText)) entity.erase("parent");
        }
        dropPlaces(entity, id, idText);
        restoreOrder(entity, id == Prefab::kRootPart ? rootText() : stringOrEmpty(idText));
        return entity;
    }

    /// Removes positions and rotations that the prefab file did not contain.
    void dropPlaces(Json& entity, std::uint64_t id, const Json& idText) const {
        Json* transform = transformOf(entity);
        if (transform == nullptr) return;
        for (const char* field : {"position", "rotation"}) {
            const Json* value = findMember(*transform, field);
            const bool drops = id == Prefab::kRootPart ? !lists(note_, kOwnPlace, field)
                                                       : lists(note_, kNoLocation, idText) &&
                                                             value != nullptr && *value == kOrigin;
            if (drops) transform->erase(field);
        }
        // A nested instance without overrides needs no "components".
        if (!entity.contains("prefab") || !transform->empty()) return;
        entity["components"].erase("Transform");
        if (entity["components"].empty()) entity.erase("components");
    }

    void restoreOrder(Json& entity, const std::string& id) const {
        const Json* all = findMember(note_, kRecord);
        const Json* record = all == nullptr ? nullptr : findMember(*all, id);
        Json* components = findObject(entity, "components");
        if (record == nullptr || components == nullptr) return;
        *components = inOrderOf(*record, *components, false);
        for (auto& [name, fields] : components->items()) {
            const Json* order = findMember(*record, name);
            if (order != nullptr && fields.is_object()) fields = inOrderOf(*order, fields, true);
        }
    }

    const Json kOrigin = Json::array({0, 0});
    const TypeRegistry& types_;
    std::map<std::uint64_t, std::uint64_t> owners_;  // instance of each part, by id
    std::map<std::uint64_t, std::size_t> places_;    // index of each entity in the scene's list, by id
    std::set<std::size_t> done_;
    Json note_ = Json::object();
    Json made_ = Json::array();
    std::uint64_t rootId_ = Prefab::kRootPart;
};

}  // namespace

bool isPrefabFile(std::string_view path) { return endsWith(path, ".prefab.json"); }

Result<LoadReport> loadFileText(World& world, const SceneContext& context, std::string_view path,
                                std::string_view text) {
    if (!isPrefabFile(path)) return loadScene(world, context, path, text);
    const Result<Json> file = parseJson(text, path);
    if (!file) return file.error();
    const Json* entities = findArray(*file, "entities");
    if (entities == nullptr || entities->empty() || !entities->front().is_object())
        return Error{std::string{path}, "expected a prefab with at least one entity",
                     R"(write {"format": 1, "entities": [...]} with the root as the first entity)"};
    if (const Json* number = findMember(*file, "format"); number != nullptr && *number != Prefab::kFormat)
        return Error{std::string{path},
                     format("expected the format {}, found {}", Prefab::kFormat, compactText(*number)),
                     "open it with the version of the engine that wrote it"};
    return guarded(path, [&] {
        return loadScene(world, context, path, writeJson(SceneOfPrefab{world, context.types}.make(*file)));
    });
}

Result<LoadReport> readFileText(World& world, const SceneContext& context, const std::string& path,
                                const std::string* text) {
    if (text == nullptr && !isPrefabFile(path)) return loadSceneFile(world, context, path);
    const Result<Path> file = pathInside(context.root, path);
    if (!file) return file.error();
    const Result<std::string> now = text == nullptr ? readFile(*file) : Result<std::string>{*text};
    if (!now) return now.error();
    Result<LoadReport> report = loadFileText(world, context, path, *now);
    if (AssetStore* assets = report ? world.service<AssetStore>() : nullptr)
        loadAssets(world, context.types, *assets);
    return report;
}

Result<Done> savePrefab(const World& world, const SceneContext& context, SceneId scene,
                        const std::string& path) {
    const std::string now = fileText(world, context, scene);
    PrefabLibrary tried{context.types, context.root};
    tried.add(path, now);
    if (const Result<const Prefab*> read = tried.find(path); !read) return read.error();
    const Result<Done> written = writeFile(context.root / path, now);
    if (context.prefabs != nullptr) context.prefabs->forget();
    return written;
}

std::string fileText(const World& world, const SceneContext& context, SceneId scene) {
    std::string text = sceneToJson(world, context, scene);
    const LoadedScenes* scenes = world.findResource<LoadedScenes>();
    const bool isPrefab =
        scenes != nullptr &&
        std::any_of(scenes->scenes.begin(), scenes->scenes.end(), [&](const LoadedScene& loaded) {
            return loaded.id == scene && isPrefabFile(loaded.path);
        });
    if (!isPrefab) return text;
    Result<Json> json = parseJson(text, "prefab");
    if (!json) return text;
    return writeJson(PrefabOfScene{world, context.types}.make(*std::move(json)));
}

bool isInside(const Path& root, std::string_view prefab, std::string_view outer) {
    std::vector<std::string> open{std::string{outer}};
    std::set<std::string> seen;
    while (!open.empty()) {
        const std::string next = std::move(open.back());
        open.pop_back();
        if (next == prefab) return true;
        if (!seen.insert(next).second) continue;
        const Result<Path> file = pathInside(root, next);
        const Result<std::string> text = file ? readFile(*file) : Result<std::string>{file.error()};
        const Result<Json> json = text ? parseJson(*text, next) : Result<Json>{text.error()};
        const Json* entities = json ? findArray(*json, "entities") : nullptr;
        if (entities == nullptr) continue;
        for (const Json& entity : *entities) {
            if (const std::string* inner = findText(entity, "prefab")) open.push_back(*inner);
        }
    }
    return false;
}

}  // namespace plumb::editor
