#include "editor/model/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/log.hpp"
#include "editor/model/bounds.hpp"
#include "editor/model/tools/tile_tools.hpp"
#include "scene/components/camera.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kEmptyScene = R"({
  "format": 1,
  "effects": {},
  "layers": [],
  "entities": []
}
)";
constexpr float kFrameMargin =
    12.0f;  // px of the screen around what the camera sees: its frame is drawn there

}  // namespace

Workspace::Workspace(const TypeRegistry& types, AssetStore& store, ProjectFolder folder,
                     PrefabLibrary* prefabs)
    : project{std::move(folder)}, assets{store}, document{types}, undo{document}, prefabs_{prefabs} {
    document.world.provide(assets);
    for (const ToolRow& row : toolTable()) {
        tools_.push_back(row.make());
    }
}

SceneContext Workspace::context() const { return {document.types(), prefabs_, project.root}; }

Result<LoadReport> Workspace::open(std::string_view path) {
    const std::string wanted{path};  // `path` may be the document's own
    play.stop();
    if (!document.scenePath.empty()) unloadScene(document.world, document.scene);
    document.world.clear();
    undo.clear();
    if (prefabs_ != nullptr) prefabs_->forget();  // their files may have changed
    Result<LoadReport> report = loadSceneFile(document.world, context(), wanted);
    document.scenePath = report ? wanted : std::string{};
    document.scene = report ? report->scene : SceneId{};
    document.reindex();
    tiles.layer = {};
    if (!report) {
        logError("Editor", report.error());
        notice = report.error().text();
        return report;
    }
    for (const Error& problem : report->problems) {
        logWarning("Editor", problem);
    }
    notice = format("Opened {}: {} entities", wanted, report->loaded);
    logNote("Editor", "{}", notice);
    showStart();
    return report;
}

Result<Done> Workspace::createScene(std::string_view name) {
    const std::string path = format("scenes/{}.scene.json", name);
    if (name.empty() || name.find('/') != std::string_view::npos)
        return Error{path, "this is no name for a scene", "write a word, e.g. \"level1\""};
    const Result<Path> file = pathInside(project.root, path);
    if (!file) return file.error();
    if (std::filesystem::exists(*file)) return Error{path, "there is such a scene", "choose another name"};
    const Result<Done> written = writeFile(*file, kEmptyScene);
    if (!written) return written;
    const Result<LoadReport> opened = open(path);
    return opened ? Result<Done>{Done{}} : Result<Done>{opened.error()};
}

void Workspace::showStart() {
    const Camera* first = nullptr;
    document.world.each<const Camera, const Transform>([&](const Camera& camera, const Transform& transform) {
        if (first != nullptr || !camera.enabled) return;
        first = &camera;
        view.centerOn(transform.position);
    });
    if (first != nullptr) {
        const float eye = std::max(first->zoom, 0.01f);
        view.show(view.view().center, view.zoomFor(project.picture / eye, kFrameMargin));
    } else if (const auto box = boundsOf(document, document.objects())) {
        view.frame(*box);
    }
}

Result<Done> Workspace::save() {
    if (document.scenePath.empty()) {
        return Error{"save", "no scene is open", "open a scene first"};
    }
    undo.endGesture();
    Result<Done> saved = saveSceneFile(document.world, context(), document.scenePath);
    if (saved) {
        undo.markSaved();
        notice = format("Saved {}", document.scenePath);
        logNote("Editor", "{}", notice);
    } else {
        notice = saved.error().text();
        logError("Editor", saved.error());
    }
    return saved;
}

std::vector<std::string> Workspace::scenes() const {
    std::vector<std::string> paths;
    for (const std::string& name : filesBelow(project.root / "scenes", ".scene.json")) {
        paths.push_back("scenes/" + name);
    }
    return paths;
}

std::string Workspace::text() const { return sceneToJson(document.world, context(), document.scene); }

std::vector<std::string> Workspace::prefabFiles() const { return filesBelow(project.root, ".prefab.json"); }

bool Workspace::selectsInstance() const {
    const World& world = document.world;
    return std::any_of(document.selection.all().begin(), document.selection.all().end(), [&](ObjectId id) {
        const EntityId entity = document.find(id);
        return world.has<PrefabInstance>(entity) || world.has<PrefabPart>(entity);
    });
}

void Workspace::revertToPrefab(const PrefabScope& scope) {
    const bool changed = editor::revertToPrefab(prefabs(), document.selection.all(), scope);
    notice = changed ? format("Did: {}", undo.label(undo.size() - 1)) : "It is as its prefab says already";
}

void Workspace::applyToPrefab(const PrefabScope& scope) {
    if (document.selection.empty()) return;
    const Result<Done> applied = editor::applyToPrefab(prefabs(), document.selection.all().back(), scope);
    notice = applied ? format("Did: {}", undo.label(undo.size() - 1)) : applied.error().text();
    if (!applied) logWarning("Editor", applied.error());
}

void Workspace::useTool(std::size_t index) {
    tool().cancel(tools());
    tool_ = std::min(index, tools_.size() - 1);
    const ToolRow& row = toolTable()[tool_];
    notice = format("{}: {}", row.name, row.hint);
    if (!row.forTiles) return;
    tiles.layer = activeTileLayer(document, tiles);
    if (!tiles.layer) notice = "This scene has no tile layer; add the component TileLayer to an entity";
}

void Workspace::useTool(std::string_view action) {
    const std::vector<ToolRow>& rows = toolTable();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].action == action) useTool(i);
    }
}

void Workspace::togglePlay() {
    if (play.running()) {
        play.stop();
        notice = "Stopped; the scene is as it was";
        return;
    }
    if (!makeSession) return;
    tool().cancel(tools());
    undo.endGesture();
    std::unique_ptr<PlaySession> session = makeSession(document.scenePath, text());
    if (session == nullptr) {
        notice = "This scene cannot be played; the console says why";
        return;
    }
    play.start(std::move(session));
    notice = "Playing";
}

bool Workspace::shows(std::string_view overlay) const {
    return std::find(overlays.begin(), overlays.end(), overlay) != overlays.end();
}

void Workspace::toggleOverlay(std::string_view overlay) {
    if (shows(overlay)) {
        std::erase(overlays, overlay);
    } else {
        overlays.emplace_back(overlay);
    }
}

}  // namespace plumb::editor
