#include "scene/import/import_tiled.hpp"

#include "assets/loaders/tmx_loader.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/import/import_entities.hpp"
#include "scene/import/tiled_json.hpp"
#include "scene/register_components.hpp"
#include "scene/scene_file.hpp"

namespace plumb {
namespace {

constexpr std::string_view kEnding = ".scene.json";
constexpr Vec2 kUsualPicture{1280.0f, 720.0f};  ///< px, of a project that does not say

/// The project around a scene: the nearest folder with a project.json, else the one around `scenes`.
Path projectAround(const Path& scene) {
    std::error_code ignored;
    const Path folder = std::filesystem::absolute(scene, ignored).lexically_normal().parent_path();
    for (Path at = folder;; at = at.parent_path()) {
        if (std::filesystem::exists(at / "project.json", ignored)) return at;
        if (at == at.parent_path()) break;
    }
    return folder.filename() == "scenes" ? folder.parent_path() : folder;
}

/// Only what the import needs; what is wrong in a project is for its loader to say.
Vec2 pictureOf(const Path& project) {
    const Result<std::string> text = readFile(project / "project.json");
    if (!text) return kUsualPicture;
    const Result<Json> json = parseJson(*text, "project.json");
    if (!json || !json->is_object()) return kUsualPicture;
    const auto found = json->find("resolution");
    const bool pair = found != json->end() && found->is_array() && found->size() == 2 &&
                      (*found)[0].is_number() && (*found)[1].is_number();
    return pair ? Vec2{(*found)[0].get<float>(), (*found)[1].get<float>()} : kUsualPicture;
}

Json groupsJson(const tiled::Map& map) {
    Json groups = Json::array();
    for (const tiled::Group& group : map.groups) {
        Json json = Json::object();
        json["path"] = group.path;
        if (!group.type.empty()) json["type"] = group.type;
        if (!group.properties.empty()) json["properties"] = group.properties;
        groups.push_back(std::move(json));
    }
    return groups;
}

/// What layers say that no component holds.
Json layersJson(const tiled::Map& map) {
    constexpr const char* kKinds[] = {"tiles", "objects", "image"};
    Json layers = Json::array();
    for (const tiled::Layer& layer : map.layers) {
        Json json = Json::object();
        json["id"] = layer.id;
        json["name"] = layer.name;
        json["kind"] = kKinds[static_cast<std::size_t>(layer.kind)];
        if (!layer.group.empty()) json["group"] = layer.group;
        if (!layer.type.empty()) json["type"] = layer.type;
        if (layer.locked) json["locked"] = true;
        if (!layer.properties.empty()) json["properties"] = layer.properties;
        layers.push_back(std::move(json));
    }
    return layers;
}

/// The names of the layers, for the lists of the editor.
Json sceneLayersJson(const tiled::Map& map) {
    Json layers = Json::array();
    for (std::size_t i = 0; i < map.layers.size() && i <= static_cast<std::size_t>(kHighestLayerOrder); ++i) {
        Json json = Json::object();
        json["name"] = map.layers[i].name;
        json["order"] = i;
        layers.push_back(std::move(json));
    }
    return layers;
}

/// The scene in the one form that saving gives it, so that opening and saving it changes nothing.
Result<std::string> savedForm(const Json& json, const std::string& path, std::vector<Error>& problems) {
    TypeRegistry types;
    registerSceneComponents(types);
    World world{types};
    const SceneContext context{types, nullptr, {}};
    Result<LoadReport> loaded = loadScene(world, context, path, writeJson(json));
    if (!loaded) return loaded.error();
    problems.insert(problems.end(), loaded->problems.begin(), loaded->problems.end());
    return sceneToJson(world, context, loaded->scene);
}

Json mapJson(const tiled::Map& map) {
    Json json = Json::object();
    json["version"] = map.version;
    if (!map.type.empty()) json["type"] = map.type;
    json["renderOrder"] = map.renderOrder;
    json["size"] = Json::array({map.width, map.height});
    json["tileSize"] = Json::array({map.tileWidth, map.tileHeight});
    if (map.infinite) json["infinite"] = true;
    if (map.parallaxOrigin != Vec2{}) json["parallaxOrigin"] = vec2Json(map.parallaxOrigin);
    json["layers"] = layersJson(map);
    if (!map.groups.empty()) json["groups"] = groupsJson(map);
    return json;
}

}  // namespace

std::string ImportReport::text() const {
    std::string text = format("{}: {} layers, {} tiles, {} objects, {} tilesets, {} images", scene, layers,
                              tiles, objects, tilesets, images);
    if (problems.empty()) return text + "; nothing was left out\n";
    text += format("; {} problems:\n", problems.size());
    for (const Error& problem : problems) text += "  " + problem.text() + "\n";
    return text;
}

Result<ImportReport> importTiled(const Path& map, const Path& scene) {
    const std::string fileName = scene.filename().string();
    if (!endsWith(fileName, kEnding) || fileName.size() == kEnding.size()) {
        return Error{scene.generic_string(), "this is no name for a scene", "end it in .scene.json"};
    }
    const std::string name = fileName.substr(0, fileName.size() - kEnding.size());
    ImportReport report;
    const Result<tiled::Map> read = loadTiledMap(map, report.problems);
    if (!read) return read.error();

    const Path root = projectAround(scene);
    ImportStage stage{root, "assets/" + name};
    std::vector<ImportedTileset> tilesets;
    for (const tiled::Tileset& tileset : read->tilesets)
        tilesets.push_back(importTileset(*read, tileset, stage));
    TileAnimations animations;
    Json json = Json::object();
    json["format"] = 1;
    if (read->background) json["background"] = colorJson({read->background->r, read->background->g, read->background->b, 255});
    if (!read->properties.empty()) json["properties"] = read->properties;
    json["tiled"] = mapJson(*read);
    json["layers"] = sceneLayersJson(*read);
    json["entities"] = importEntities({*read, tilesets, stage, animations, report, pictureOf(root)});

    std::error_code ignored;
    report.scene = std::filesystem::absolute(scene, ignored)
                       .lexically_normal()
                       .lexically_relative(root)
                       .generic_string();
    const Result<std::string> text = savedForm(json, report.scene, stage.problems);
    if (!text) return text.error();
    Result<std::vector<std::string>> written = stage.write();
    if (!written) return written.error();
    if (const Result<Done> done = writeFile(scene, *text); !done) return done.error();
    report.files = std::move(*written);
    report.files.push_back(report.scene);
    report.tilesets = static_cast<int>(tilesets.size());
    report.images = static_cast<int>(stage.imageCount());
    report.problems.insert(report.problems.end(), stage.problems.begin(), stage.problems.end());
    return report;
}

}  // namespace plumb
