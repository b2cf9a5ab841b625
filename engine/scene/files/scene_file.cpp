#include "scene/files/scene_file.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>

#include "assets/asset_store.hpp"
#include "core/guarded.hpp"
#include "core/limits.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "reflect/cbor.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/persistent.hpp"
#include "scene/files/json_slices.hpp"
#include "scene/files/missing_file.hpp"
#include "scene/files/scene_assets.hpp"
#include "scene/files/scene_reader.hpp"
#include "scene/files/scene_writer.hpp"

namespace plumb {
namespace {

/// Key in the binary format for the text of an entity that could not be read.
constexpr const char* kTextKey = "$text";

Error noScene(std::string_view path, const std::string& what) {
    return {std::string{path}, what,
            "write {\"format\": 1, \"effects\": {}, \"layers\": [], \"entities\": [...]}"};
}

/// Returns the error of a text that could not be sliced, from the strict JSON parser.
Error brokenText(std::string_view path, std::string_view text) {
    const Result<Json> json = parseJson(text, path);
    if (!json) return json.error();
    return noScene(path, "expected a scene, found " + foundText(*json));
}

/// Parses a slice; lines and columns in errors are those of the whole text.
Result<Json> parseSlice(std::string_view text, std::string_view slice, std::string_view path) {
    Result<Json> json = parseJson(slice, path);
    if (json.ok()) return json;
    const auto start = static_cast<std::size_t>(slice.data() - text.data());
    const std::string_view before = text.substr(0, start);
    std::string padded(static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')), '\n');
    padded.append(start - (before.rfind('\n') + 1), ' ');
    return parseJson(padded.append(slice), path);
}

Result<Done> readFormat(SceneReader& reader, const Json* json) {
    if (json == nullptr) {
        reader.problem("format", "the key is missing", format("reading it as format {}", kSceneFormat));
        return Done{};
    }
    const bool whole = json->is_number_integer() && json->get<std::int64_t>() >= 0;
    if (!whole || json->get<std::int64_t>() > kSceneFormat) {
        return Error{reader.path() + ": format",
                     format("expected 0 to {}, found {}", kSceneFormat, foundText(*json)),
                     "open it with the version of the engine that wrote it"};
    }
    reader.fileFormat = static_cast<int>(json->get<std::int64_t>());
    return Done{};
}

void readHead(SceneReader& reader, const std::string& key, Json value) {
    if (key == "effects") {
        reader.readEffects(value);
    } else if (key == "layers") {
        reader.readLayers(value);
    } else if (key != "format") {
        reader.keepKey(key, std::move(value));
    }
}

Result<Done> checkCount(std::string_view path, std::size_t count) {
    if (count <= limits::kEntities) return Done{};
    return Error{std::string{path} + ": entities",
                 format("{} entities, the limit is {}", count, limits::kEntities), "split the scene"};
}

using Slices = std::vector<std::pair<std::string_view, std::string_view>>;

std::string_view sliceOf(const Slices& slices, std::string_view key) {
    const auto found =
        std::find_if(slices.begin(), slices.end(), [key](const auto& s) { return s.first == key; });
    return found == slices.end() ? std::string_view{} : found->second;
}

/// Reads everything except the entities first, so that a file that is not a scene does not change the world.
Result<Done> readHeads(SceneReader& reader, std::string_view text, const Slices& slices) {
    std::vector<std::pair<std::string, Json>> heads;
    for (const auto& [key, slice] : slices) {
        if (key == "entities") continue;
        // Parse the key with its quotes to decode escape sequences.
        Result<Json> name = parseSlice(text, {key.data() - 1, key.size() + 2}, reader.path());
        if (!name) return name.error();
        Result<Json> json = parseSlice(text, slice, reader.path());
        if (!json) return json.error();
        heads.emplace_back(stringOrEmpty(*name), std::move(*json));
        const std::string& last = heads.back().first;
        const bool known =
            std::any_of(heads.begin(), heads.end() - 1, [&](const auto& head) { return head.first == last; });
        if (known || last == "entities")
            return noScene(reader.path(), format("the key \"{}\" appears twice", last));
    }
    const auto found =
        std::find_if(heads.begin(), heads.end(), [](const auto& head) { return head.first == "format"; });
    if (auto format = readFormat(reader, found == heads.end() ? nullptr : &found->second); !format)
        return format.error();
    for (auto& [key, value] : heads) readHead(reader, key, std::move(value));
    return Done{};
}

Result<LoadReport> readText(World& world, const SceneContext& context, std::string_view path,
                            std::string_view text) {
    if (text.size() > limits::kFileBytes) return brokenText(path, text);
    if (startsWith(text, "\xef\xbb\xbf")) text.remove_prefix(3);
    const auto slices = sliceObject(text);
    if (!slices) return brokenText(path, text);
    const auto lists =
        std::count_if(slices->begin(), slices->end(), [](const auto& s) { return s.first == "entities"; });
    if (lists > 1) return noScene(path, "the key \"entities\" appears twice");
    const std::string_view list = sliceOf(*slices, "entities");
    const auto entities = sliceArray(list.empty() ? std::string_view{"[]"} : list);
    if (!entities) return noScene(path, "\"entities\" is not a JSON array");
    if (auto count = checkCount(path, entities->size()); !count) return count.error();

    SceneReader reader{world, context, path};
    if (auto heads = readHeads(reader, text, *slices); !heads) return heads.error();
    if (list.empty())
        reader.problem("entities", "the key is missing", "reading it as a scene without entities");
    reader.reserve(entities->size());
    for (std::size_t i = 0; i < entities->size(); ++i) {
        const std::string_view slice = (*entities)[i];
        Result<Json> json = parseSlice(text, slice, path);
        if (json) {
            reader.readEntity(std::move(*json), static_cast<int>(i), slice);
        } else {
            reader.skipEntity(static_cast<int>(i), slice, json.error());
        }
    }
    return reader.finish();
}

Result<LoadReport> readBinary(World& world, const SceneContext& context, std::string_view path,
                              std::string_view bytes) {
    Result<Json> json = readCbor(bytes, path);
    if (!json) return json.error();
    if (!json->is_object()) return noScene(path, "expected a scene, found " + foundText(*json));
    Json* entities = findMember(*json, "entities");
    if (entities != nullptr && !entities->is_array())
        return noScene(path, "\"entities\" is not a JSON array");
    if (auto count = checkCount(path, entities == nullptr ? 0 : entities->size()); !count)
        return count.error();

    SceneReader reader{world, context, path};
    if (auto read = readFormat(reader, findMember(*json, "format")); !read) return read.error();
    for (auto& [key, value] : *json->get_ptr<Json::object_t*>()) {
        if (key != "entities") readHead(reader, key, std::move(value));
    }
    if (entities == nullptr) {
        reader.problem("entities", "the key is missing", "reading it as a scene without entities");
        return reader.finish();
    }
    int place = 0;
    for (Json& entity : *entities) {
        const std::string* text = entity.size() == 1 ? findText(entity, kTextKey) : nullptr;
        if (text == nullptr) {
            reader.readEntity(std::move(entity), place, {});
        } else if (Result<Json> parsed = parseJson(*text, path)) {
            reader.readEntity(std::move(*parsed), place, *text);
        } else {
            reader.skipEntity(place, *text, parsed.error());
        }
        ++place;
    }
    return reader.finish();
}

}  // namespace

Result<LoadReport> loadScene(World& world, const SceneContext& context, std::string_view path,
                             std::string_view text) {
    return guarded(path, [&] { return readText(world, context, path, text); });
}

Result<LoadReport> loadSceneBinary(World& world, const SceneContext& context, std::string_view path,
                                   std::string_view bytes) {
    return guarded(path, [&] { return readBinary(world, context, path, bytes); });
}

std::string sceneToJson(const World& world, const SceneContext& context, SceneId scene) {
    const LoadedScenes* scenes = world.findResource<LoadedScenes>();
    const LoadedScene* found = scenes == nullptr ? nullptr : const_cast<LoadedScenes*>(scenes)->find(scene);
    PLUMB_ASSERT(found != nullptr, "only a scene that was loaded or added can be written");
    const LoadedScene empty;
    return SceneWriter{const_cast<World&>(world), context, found == nullptr ? empty : *found}.write();
}

std::string sceneToBinary(const World& world, const SceneContext& context, SceneId scene) {
    const std::string text = sceneToJson(world, context, scene);
    const auto slices = sliceObject(text);
    PLUMB_ASSERT(slices.has_value(), "the text of a scene is an object");
    Json json = Json::object();
    for (const auto& [key, slice] : *slices) {
        if (key != "entities") {
            if (Result<Json> value = parseJson(slice, key)) json[std::string{key}] = std::move(*value);
            continue;
        }
        Json& list = json["entities"] = Json::array();
        const auto entities = sliceArray(slice);
        for (const std::string_view entity : entities ? *entities : std::vector<std::string_view>{}) {
            Result<Json> value = parseJson(entity, key);
            list.push_back(value.ok() ? std::move(*value) : Json{{kTextKey, std::string{entity}}});
        }
    }
    return writeCbor(json);
}

Result<LoadReport> loadSceneFile(World& world, const SceneContext& context, std::string_view path) {
    Result<Path> file = pathInside(context.root, path);
    if (!file) return file.error();
    if (!fileExists(*file))
        return missingFile(context.root, path, endsWith(path, ".bin") ? ".scene.bin" : ".scene.json");
    Result<std::string> bytes = readFile(*file);
    if (!bytes) return bytes.error();
    Result<LoadReport> report = endsWith(path, ".bin") ? loadSceneBinary(world, context, path, *bytes)
                                                       : loadScene(world, context, path, *bytes);
    if (AssetStore* assets = world.service<AssetStore>(); report.ok() && assets != nullptr) {
        loadAssets(world, context.types, *assets);
    }
    return report;
}

Result<Done> saveSceneFile(const World& world, const SceneContext& context, std::string_view path) {
    return saveSceneFileAs(world, context, sceneId(path), path);
}

Result<Done> saveSceneFileAs(const World& world, const SceneContext& context, SceneId scene,
                             std::string_view path) {
    Result<Path> file = pathInside(context.root, path);
    if (!file) return file.error();
    return writeFile(*file, endsWith(path, ".bin") ? sceneToBinary(world, context, scene)
                                                   : sceneToJson(world, context, scene));
}

SceneId addScene(World& world, std::string_view path) {
    LoadedScenes& scenes = world.resource<LoadedScenes>();
    LoadedScene scene;
    scene.id = {world.texts().add(path)};
    scene.path = path;
    return scenes.add(std::move(scene)).id;
}

Entity createSceneEntity(World& world, SceneId scene, Random& ids) {
    int order = -1;
    for (auto [other, source] : std::as_const(world).query<const SceneEntity>(withPaused)) {
        if (source.scene == scene) order = std::max(order, source.order);
    }
    const Entity entity = world.createEntity();
    entity.addComponent<SceneEntity>(SceneEntity{newStableId(ids), order + 1, scene});
    return entity;
}

bool persists(const World& world, EntityId id) {
    for (; world.alive(id); id = parentOf(world, id)) {
        if (world.has<Persistent>(id)) return true;
    }
    return false;
}

namespace {

std::vector<EntityId> entitiesOf(const World& world, SceneId scene) {
    std::vector<EntityId> ids;
    for (auto [entity, source] : world.query<const SceneEntity>(without<Persistent>, withPaused)) {
        if (source.scene == scene) ids.push_back(entity.id());
    }
    return ids;
}

void unload(World& world, SceneId scene, const std::vector<EntityId>& entities) {
    for (const EntityId id : entities) {
        if (world.alive(id) && !persists(world, id)) world.destroy(id);
    }
    world.dropUnusedTiles();
    if (LoadedScenes* scenes = world.findResource<LoadedScenes>()) {
        std::erase_if(scenes->scenes, [scene](const LoadedScene& s) { return s.id == scene; });
    }
}

}  // namespace

void unloadScene(World& world, SceneId scene) { unload(world, scene, entitiesOf(world, scene)); }

void unloadOverlay(World& world, SceneId scene) {
    std::vector<EntityId> entities = entitiesOf(world, scene);
    std::reverse(entities.begin(), entities.end());
    unload(world, scene, entities);
}

void loadAssets(const World& world, const TypeRegistry& types, AssetStore& assets) {
    for (const AssetName& name : namedAssets(world, types))
        assets.load(name.kind, world.texts().find(name.path));
}

std::uint64_t newStableId(Random& random) {
    std::uint64_t id = random.next64();
    while (id <= Prefab::kRootPart) id = random.next64();
    return id;
}

}  // namespace plumb
