#include "import/scene_draft.hpp"

#include <algorithm>
#include <optional>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "import/tiled_json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"

namespace plumb {
namespace {

constexpr Vec2 kDefaultResolution{1280.0f, 720.0f};  ///< px, if the project file has none
constexpr int kBehindAll = -1000;

/// Returns the project folder of a file: the nearest folder above it with a project.json; without one, the
/// parent of the folder `scenes`, else the file's own folder.
Path projectAround(const Path& file) {
    std::error_code ignored;
    const Path folder = file.parent_path();
    for (Path at = folder;; at = at.parent_path()) {
        if (std::filesystem::exists(at / "project.json", ignored)) return at;
        if (at == at.parent_path()) break;
    }
    return folder.filename() == "scenes" ? folder.parent_path() : folder;
}

/// Reads the resolution from project.json, px. Errors are ignored here: loading the project reports them.
Vec2 resolutionOf(const Path& project) {
    const Result<std::string> text = readFile(project / "project.json");
    if (!text) return kDefaultResolution;
    const Result<Json> json = parseJson(*text, "project.json");
    if (!json) return kDefaultResolution;
    const Json* found = findArray(*json, "resolution");
    if (found == nullptr || found->size() != 2) return kDefaultResolution;
    const std::optional<float> width = floatOf((*found)[0]);
    const std::optional<float> height = floatOf((*found)[1]);
    return width && height ? Vec2{*width, *height} : kDefaultResolution;
}

}  // namespace

Result<ImportTarget> ImportTarget::of(const Path& file, std::string_view ending) {
    std::error_code ignored;
    const Path whole = std::filesystem::absolute(file, ignored).lexically_normal();
    const std::string name = whole.filename().string();
    if (!endsWith(name, ending) || name.size() == ending.size()) {
        return Error{file.generic_string(), "the file to write has the wrong extension",
                     format("use a name that ends in {}", ending)};
    }
    ImportTarget place;
    place.root = projectAround(whole);
    place.path = whole.lexically_relative(place.root).generic_string();
    place.name = name.substr(0, name.size() - ending.size());
    place.picture = resolutionOf(place.root);
    return place;
}

SceneDraft::SceneDraft(ImportTarget where) : place{std::move(where)}, stage{"assets/" + place.name} {
    report.scene = place.path;
}

std::string SceneDraft::add(std::string_view key, const std::string& name, Json components) {
    Json entity = Json::object();
    std::string id = ids_.next(key);
    entity["id"] = id;
    if (!name.empty()) entity["name"] = name;
    if (!parents_.empty()) entity["parent"] = parents_.back();
    entity["components"] = std::move(components);
    entities_.push_back(std::move(entity));
    return id;
}

std::string SceneDraft::open(std::string_view key, const std::string& name, Vec2 position) {
    Json components = Json::object();
    components["Transform"] = transformJson(position, 0.0f, {1.0f, 1.0f});
    parents_.push_back(add(key, name, std::move(components)));
    return parents_.back();
}

void SceneDraft::addCamera(const Rect& bounds) {
    Json components = Json::object();
    components["Transform"] =
        transformJson({bounds.x + bounds.width * 0.5f, bounds.y + bounds.height * 0.5f}, 0.0f, {1.0f, 1.0f});
    Json& camera = components["Camera"] = Json::object();
    if (!bounds.empty()) camera["limits"] = Json::array({bounds.x, bounds.y, bounds.width, bounds.height});
    add("camera/camera", "camera", std::move(components));
}

void SceneDraft::addBackground(std::string_view key, const Rect& area, Color color) {
    Json components = Json::object();
    components["Transform"] = transformJson({area.x, area.y}, 0.0f, {1.0f, 1.0f});
    Json& sprite = components["Sprite"] = Json::object();
    sprite["width"] = static_cast<int>(area.width);
    sprite["height"] = static_cast<int>(area.height);
    sprite["layer"] = kBehindAll;
    sprite["tint"] = colorJson(color);
    add(key, "background", std::move(components));
}

void SceneDraft::nameLayer(int order, std::string_view name) {
    layers_.try_emplace(order, std::string{name});
}

Result<std::string> SceneDraft::savedForm(const Json& json) {
    TypeRegistry types;
    registerSceneComponents(types);
    World world{types};
    const SceneContext context{types, nullptr, {}};
    Result<LoadReport> loaded = loadScene(world, context, place.path, writeJson(json));
    if (!loaded) return loaded.error();
    report.problems.insert(report.problems.end(), loaded->problems.begin(), loaded->problems.end());
    return sceneToJson(world, context, loaded->scene);
}

Result<ImportReport> SceneDraft::finish(std::vector<ImportedFile>& files) {
    Json json = Json::object();
    json["format"] = kSceneFormat;
    for (const auto& [key, value] : extra.items()) json[key] = value;
    json["layers"] = Json::array();
    for (const auto& [order, name] : layers_) {
        Json layer = Json::object();
        layer["name"] = name;
        layer["order"] = order;
        json["layers"].push_back(std::move(layer));
    }
    json["entities"] = std::move(entities_);
    Result<std::string> text = savedForm(json);
    if (!text) return text.error();
    std::vector<ImportedFile> own = stage.takeFiles();
    own.push_back({place.path, *std::move(text)});
    for (ImportedFile& file : own) {
        report.files.push_back(file.path);
        files.push_back(std::move(file));
    }
    report.images = static_cast<int>(stage.imageCount());
    report.problems.insert(report.problems.end(), stage.problems.begin(), stage.problems.end());
    return std::move(report);
}

Result<ImportReport> SceneDraft::write() {
    std::vector<ImportedFile> files;
    Result<ImportReport> finished = finish(files);
    if (!finished) return finished;
    if (const Result<Done> done = commitImport(place.root, files); !done) return done.error();
    return finished;
}

}  // namespace plumb
