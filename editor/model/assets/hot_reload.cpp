#include "editor/model/assets/hot_reload.hpp"

#include "assets/asset_store.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/assets/reload_document.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"

namespace plumb::editor {
namespace {

constexpr double kWatchInterval = 2.0;  // s between two searches for new prefabs

SceneContext contextOf(Workspace& workspace) {
    const PrefabEdit edit = workspace.prefabs();
    return {workspace.document.types(), edit.prefabs, edit.root};
}

}  // namespace

void HotReload::watch() {
    Workspace& w = workspace_;
    if (w.document.scenePath != watchedScene_) {
        watchedScene_ = w.document.scenePath;
        if (!watchedScene_.empty() && !editsPrefab(w)) w.assets.load(AssetKind::Scene, watchedScene_);
    }
    for (const std::string& path : w.prefabFiles()) w.assets.load(AssetKind::Prefab, path);
}

/// Loads newly referenced assets: every edit that references a file (a new instance, a paste, a field) adds
/// its path to the texts of the world.
void HotReload::loadNewlyNamed() {
    const Document& document = workspace_.document;
    if (document.world.texts().size() == knownTexts_) return;
    knownTexts_ = document.world.texts().size();
    loadAssets(document.world, document.types(), workspace_.assets);
}

std::size_t HotReload::poll(double now) {
    Workspace& w = workspace_;
    loadNewlyNamed();
    if (now < next_) return 0;
    next_ = now + kInterval;
    if (now >= nextWatch_ || w.document.scenePath != watchedScene_) {
        nextWatch_ = now + kWatchInterval;
        watch();
    }
    if (AssetStore* playing = w.play.assets(); playing != nullptr && playing != &w.assets)
        static_cast<void>(playing->pollChanges(playing->size()));
    // Nothing is reloaded during a drag, which refers to the present entities.
    if (w.undo.inGesture()) return 0;
    std::size_t taken = 0;
    std::vector<std::string> prefabs;
    for (const AssetChange& change : w.assets.pollChanges(w.assets.size())) {
        const std::string path{w.assets.pathOf(change.kind, change.path)};
        ++taken;
        const bool isOpen = path == w.document.scenePath;
        if (change.kind == AssetKind::Prefab && !isOpen) prefabs.push_back(path);
        if (change.kind == AssetKind::Scene || change.kind == AssetKind::Prefab) {
            if (isOpen) sceneChanged();
        } else {
            w.notice = format("Reloaded the {} {}", nameOfKind(change.kind), path);
        }
    }
    if (!prefabs.empty()) prefabsChanged(prefabs);
    return taken;
}

void HotReload::prefabsChanged(const std::vector<std::string>& paths) {
    Workspace& w = workspace_;
    if (w.document.scenePath.empty()) return;
    // The scene's text holds only the overrides of instances; all else comes from the new prefab.
    const std::string text = w.text();
    if (PrefabLibrary* prefabs = w.prefabs().prefabs) {
        prefabs->forget();
        for (const std::string& path : paths) static_cast<void>(prefabs->named(path));  // logs what is wrong
    }
    if (const Result<LoadReport> loaded = reloadDocument(w.document, contextOf(w), text); !loaded)
        logError("Editor", loaded.error());
    w.notice = "Reloaded the prefabs";
}

void HotReload::sceneChanged() {
    Workspace& w = workspace_;
    std::error_code failed;
    const Path file = w.project.root / w.document.scenePath;
    if (!std::filesystem::exists(file, failed)) return;  // it is being replaced by another program
    // The hash check recognizes the editor's own saves. It comes first because making the text of a large
    // scene takes longer than a frame.
    w.safety.lookAtFile();
    if (w.safety.onDisk() == FileWatch::State::Same) return;
    const Result<std::string> text = readFile(file);
    if (!text || *text == w.text()) return;
    if (w.unsaved()) return;  // the safety dialog asks the user
    const Result<LoadReport> loaded = reloadDocument(w.document, contextOf(w), *text);
    if (!loaded) {
        w.notice = loaded.error().text();
        return logError("Editor", loaded.error());
    }
    w.undo.clear();
    w.safety.opened();
    w.notice = format("Reloaded {}, which was changed by another program", w.document.scenePath);
    logNote("Editor", "{}", w.notice);
}

}  // namespace plumb::editor
