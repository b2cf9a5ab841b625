#include "editor/model/workspace.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/effect_rows.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/play/played_keys.hpp"
#include "editor/model/prefabs/prefab_group.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/model/problems.hpp"
#include "editor/model/project/project_habits.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kEmptyScene = R"({
  "format": 1,
  "effects": {},
  "layers": [],
  "entities": []
}
)";
constexpr float kFrameMargin = 12.0f;  // screen px around the camera's area, in which its frame is drawn

}  // namespace

Workspace::Workspace(const TypeRegistry& types, AssetStore& store, ProjectFolder folder,
                     PrefabLibrary* prefabs)
    : project{std::move(folder)}, assets{store}, document{types}, undo{document}, prefabs_{prefabs} {
    document.picture = project.picture;
    document.world.provide(assets);
    document.world.provide(engineEffects());
    readGrid(*this);
    readBreakpoints(*this);
    for (const ToolRow& row : toolTable()) {
        tools_.push_back(row.make());
    }
}

SceneContext Workspace::context() const { return {document.types(), prefabs_, project.root}; }

Result<LoadReport> Workspace::open(std::string_view path) { return load(std::string{path}, nullptr); }

Result<LoadReport> Workspace::openText(std::string_view path, const std::string& text) {
    Result<LoadReport> report = load(std::string{path}, &text);
    if (report) undo.markUnsaved();
    return report;
}

/// @param text  read instead of the file; null: the file is read
Result<LoadReport> Workspace::load(const std::string& wanted, const std::string* text) {
    safety.leaving();
    const std::string left = undo.total() > 0 && wanted != document.scenePath ? document.scenePath : "";
    viewFile.keep(document.scenePath, document.view);
    play.stop();
    offeredChanges.clear();
    if (!document.scenePath.empty()) unloadScene(document.world, document.scene);
    document.world.clear();
    undo.clear();
    if (prefabs_ != nullptr) prefabs_->forget();  // the prefab files may have changed
    Result<LoadReport> report = readFileText(document.world, context(), wanted, text);
    document.scenePath = report ? wanted : std::string{};
    document.scene = report ? report->scene : SceneId{};
    document.reindex();
    safety.opened();
    tiles.layer = {};
    tiles.selected.clear();
    viewFile.read(document.scenePath, document.view);
    problemsOf(*this).load = report ? std::string{} : report.error().text();
    if (!report) {
        logError("Editor", report.error());
        notice = report.error().text();
        return report;
    }
    for (const Error& problem : report->problems) {
        logWarning("Editor", problem);
    }
    // Counts parts of prefabs too, like the tree and the status bar.
    const std::size_t count = document.objectCount();
    notice = format("Opened {}: {} {}", wanted, count, count == 1 ? "entity" : "entities");
    logNote("Editor", "{}", notice);
    if (!left.empty()) notice += format("; the undo history of {} was cleared", left);
    showStart();
    return report;
}

Result<Done> Workspace::createScene(std::string_view name) {
    const Result<Path> file = newSceneFile(project.root, name);
    if (!file) return file.error();
    const Result<Done> written = writeFile(*file, kEmptyScene);
    if (!written) return written;
    const Result<LoadReport> opened = open(format("scenes/{}.scene.json", name));
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

/// Reports success as well as failure: a save that failed silently would lose work.
Result<Done> Workspace::save() {
    const Result<Done> saved = write();
    const bool asked = safety.onDisk() == FileWatch::State::Changed;  // a dialog asks which version to keep
    problemsOf(*this).save = saved || asked ? std::string{} : saved.error().text();
    notice = saved ? format("Saved {}", document.scenePath) : saved.error().text();
    if (saved) {
        logNote("Editor", "{}", notice);
    } else {
        logError("Editor", saved.error());
    }
    return saved;
}

Result<Done> Workspace::saveAs(std::string_view name) {
    if (document.scenePath.empty() || isPrefabFile(document.scenePath))
        return Error{"save as", "no scene is open", "open a scene first"};
    const Result<Path> file = newSceneFile(project.root, name);
    if (!file) return file.error();
    undo.endGesture();
    if (const Result<Done> written = writeFile(*file, text()); !written) return written;
    document.scenePath = format("scenes/{}.scene.json", name);
    undo.markSaved();
    safety.saved();
    viewFile = ViewFile{project.root};  // writes what is hidden and locked for the new scene, too
    notice = format("Saved {}", document.scenePath);
    logNote("Editor", "{}", notice);
    return Done{};
}

Result<Done> Workspace::write() {
    if (document.scenePath.empty()) {
        return Error{"save", "no scene is open", "open a scene first"};
    }
    undo.endGesture();
    safety.lookAtFile();
    if (safety.onDisk() == FileWatch::State::Changed) {
        safety.refuse();
        return Error{document.scenePath, "the file was changed by another program",
                     "choose the version to keep"};
    }
    safety.saving();
    const bool prefab = isPrefabFile(document.scenePath);
    std::string written;
    if (!prefab) {
        written = endsWith(document.scenePath, ".bin")
                      ? sceneToBinary(document.world, context(), document.scene)
                      : text();
    }
    const Result<Path> file = pathInside(project.root, document.scenePath);
    safety.finish();
    Result<Done> saved = prefab ? savePrefab(document.world, context(), document.scene, document.scenePath)
                         : file ? writeFile(*file, written)
                                : Result<Done>{file.error()};
    if (!saved) return saved;
    undo.markSaved();
    safety.saved();
    return saved;
}

std::vector<std::string> Workspace::scenes() const {
    std::vector<std::string> paths;
    for (const std::string& name : filesBelow(project.root / "scenes", ".scene.json")) {
        paths.push_back("scenes/" + name);
    }
    return paths;
}

std::string Workspace::text() const { return fileText(document.world, context(), document.scene); }

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
    notice = changed ? format("Did: {}", undo.label(undo.size() - 1))
                     : "The selected entities already match their prefab";
}

void Workspace::applyToPrefab(const PrefabScope& scope) {
    if (document.selection.empty()) return;
    const Result<Done> applied = applyAllToPrefabs(prefabs(), document.selection.all(), scope);
    notice = applied ? format("Did: {}", undo.label(undo.size() - 1)) : applied.error().text();
    if (!applied) logWarning("Editor", applied.error());
}

void Workspace::useTool(std::size_t index) {
    tool().cancel(tools());
    tool_ = std::min(index, tools_.size() - 1);
    const ToolRow& row = toolTable()[tool_];
    notice = format("{}: {}", row.name, withKeys(*this, row.hint));
    if (!row.forTiles) return;
    tiles.layer = activeTileLayer(document, tiles);
    if (row.paintChoice != PaintChoice::Unchanged)
        tiles.activeTerrain = row.paintChoice == PaintChoice::Terrain;
    const Tileset* tileset = tilesetOf(document, tiles.layer);
    if (document.scenePath.empty()) {
        notice = "No scene is open";
    } else if (!tiles.layer) {
        notice = "This scene has no tile layer; add one in the Tiles panel, or drag a tileset into the scene";
    } else if (row.paintChoice == PaintChoice::Terrain && (tileset == nullptr || tileset->terrains.empty())) {
        notice = "This tileset has no terrain yet; create one in the Tileset panel";
    }
}

void Workspace::useTool(std::string_view action) {
    const std::vector<ToolRow>& rows = toolTable();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].action == action) useTool(i);
    }
}

void Workspace::togglePlay() { play.running() ? stopPlaying() : startPlaying(); }

void Workspace::startPlaying(bool paused) {
    if (!makeSession) return;
    if (editsPrefab(*this)) return askToPlayScene(*this, paused);  // a prefab alone is not playable
    clearPlayedKeys(*this);
    tool().cancel(tools());
    undo.endGesture();
    offeredChanges.clear();
    std::unique_ptr<PlaySession> session = makeSession(document.scenePath, text());
    if (session == nullptr) {
        notice = "This scene cannot be played; see the console for the reason";
        return;
    }
    play.start(std::move(session), paused);
    profiler.update(play);  // records the first tick too
    notice = paused ? "Paused before the first tick" : std::string{kPlayingNotice};
}

void Workspace::stopPlaying() {
    if (!play.running()) return;
    offeredChanges = changesToKeep(document, play.world(), play.edits());
    play.stop();
    notice = "Stopped; the scene is unchanged";
}

void Workspace::keepTicked() {
    const std::size_t kept = keepChanges(document, undo, offeredChanges);
    offeredChanges.clear();
    notice = kept == 0
                 ? "Nothing was kept"
                 : format("Kept {} changes of the game; press {} to undo", kept, keysFor(*this, "edit.undo"));
}

void Workspace::update(double seconds) {
    safety.update(seconds);
    profiler.update(play);
    scripts.update(seconds);
    viewFile.keep(document.scenePath, document.view);
    updatePlayedKeys(*this);
    updateGrid(*this, seconds);
    const bool open = !document.scenePath.empty() && !editsPrefab(*this);
    const PhysicsReach jumps = open ? reachOf("reach") : PhysicsReach::Off;
    jumps == PhysicsReach::Off ? reach.clear() : reach.update(*this, jumps == PhysicsReach::All);
    const PhysicsReach paths = open ? reachOf("trajectories") : PhysicsReach::Off;
    paths == PhysicsReach::Off ? trajectories.clear()
                               : trajectories.update(*this, paths == PhysicsReach::All);
}

PhysicsReach Workspace::reachOf(std::string_view overlay) const {
    const auto in = [overlay](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), overlay) != names.end();
    };
    return in(overlays)             ? PhysicsReach::All
           : in(overlaysOfSelected) ? PhysicsReach::Selected
                                    : PhysicsReach::Off;
}

void Workspace::setReach(std::string_view overlay, PhysicsReach whose) {
    std::erase(overlays, overlay);
    std::erase(overlaysOfSelected, overlay);
    if (whose == PhysicsReach::All) overlays.emplace_back(overlay);
    if (whose == PhysicsReach::Selected) overlaysOfSelected.emplace_back(overlay);
}

void Workspace::toggleOverlay(std::string_view overlay) {
    setReach(overlay, shows(overlay) ? PhysicsReach::Off : PhysicsReach::All);
}

}  // namespace plumb::editor
