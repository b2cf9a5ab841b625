#include "editor/model/prefabs/prefab_visit.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "scene/components/prefab_instance.hpp"

namespace plumb::editor {
namespace {

/// The file, view and selection before a prefab was opened.
struct CameFrom {
    std::string path;  // file of the scene or prefab
    Vec2 center;       // px, world: center of the view
    float zoom = 1.0f;
    std::vector<ObjectId> selection;
};

/// The stack of opened prefabs. A resource of the document's world, which is kept when another file is
/// opened.
struct Trail {
    std::vector<CameFrom> places;  // files to go back to; the first is a scene
    std::string to;  // path of the prefab opened last; `places` is invalid if another file is open
    std::optional<PrefabVisit> asked;
};

Trail& trailOf(Workspace& workspace) {
    Trail& trail = workspace.document.world.resource<Trail>();
    if (trail.to != workspace.document.scenePath) trail.places.clear();
    return trail;
}
/// Null if no trail leads to the open file.
const Trail* trailOf(const Workspace& workspace) {
    const Trail* trail = workspace.document.world.findResource<Trail>();
    return trail == nullptr || trail->to != workspace.document.scenePath ? nullptr : trail;
}

std::string firstScene(const Workspace& workspace) {
    const std::vector<std::string> scenes = workspace.scenes();
    return scenes.empty() ? std::string{} : scenes.front();
}

/// Opens the file again, with its former view and selection.
Result<LoadReport> goBack(Workspace& workspace, CameFrom to) {
    Result<LoadReport> report = workspace.open(to.path);
    if (!report) return report;
    workspace.view.show(to.center, to.zoom);
    std::erase_if(to.selection, [&](ObjectId id) { return !workspace.document.find(id); });
    workspace.document.selection.set(std::move(to.selection));
    return report;
}

}  // namespace

bool editsPrefab(const Workspace& workspace) { return isPrefabFile(workspace.document.scenePath); }

std::string selectedPrefab(const Workspace& workspace) {
    const Document& document = workspace.document;
    const World& world = document.world;
    TextId one;
    for (const ObjectId id : document.selection.all()) {
        const PrefabPart* link = world.find<PrefabPart>(document.find(id));
        const ObjectId root = link == nullptr ? id : ObjectId{link->instance};
        const PrefabInstance* instance = world.find<PrefabInstance>(document.find(root));
        if (instance == nullptr) continue;
        if (!one.empty() && one != instance->prefab.path) return {};
        one = instance->prefab.path;
    }
    return std::string{world.texts().find(one)};
}

Result<LoadReport> editPrefab(Workspace& workspace, const std::string& path) {
    Document& document = workspace.document;
    if (path == document.scenePath) return Error{path, "this prefab is already open", ""};
    // A prefab that cannot be read must not replace the open file.
    PrefabLibrary tried{document.types(), workspace.project.root};
    if (const Result<const Prefab*> read = tried.find(path); !read) {
        workspace.notice = read.error().text();
        return read.error();
    }
    std::vector<CameFrom> way = trailOf(workspace).places;
    const View view = workspace.view.view();
    const CameFrom here{document.scenePath, view.center, view.zoom, document.selection.all()};
    // If the prefab is in the trail already, the trail is cut back to it.
    const auto known =
        std::find_if(way.begin(), way.end(), [&](const CameFrom& place) { return place.path == path; });
    const bool onTheWay = known != way.end();
    way.erase(known, way.end());
    if (!onTheWay && !here.path.empty()) way.push_back(here);
    Result<LoadReport> report = workspace.open(path);
    if (!report) {
        const Error problem = report.error();
        if (!here.path.empty()) static_cast<void>(goBack(workspace, here).ok());
        workspace.notice = problem.text();
        return problem;
    }
    Trail& trail = document.world.resource<Trail>();
    trail.places = std::move(way);
    trail.to = path;
    if (const ObjectId root = prefabRootOf(document); document.find(root)) document.selection.set({root});
    workspace.notice = format("Editing the prefab {}; saving changes all of its instances", path);
    return report;
}

std::string fileToReturnTo(const Workspace& workspace) {
    if (!editsPrefab(workspace)) return {};
    const Trail* trail = trailOf(workspace);
    return trail == nullptr || trail->places.empty() ? firstScene(workspace) : trail->places.back().path;
}

Result<LoadReport> leavePrefab(Workspace& workspace) {
    const std::string behind = fileToReturnTo(workspace);
    if (behind.empty())
        return Error{workspace.document.scenePath, "the project has no scene to go back to",
                     "create a scene first"};
    Trail& trail = trailOf(workspace);
    if (trail.places.empty()) return workspace.open(behind);
    CameFrom to = std::move(trail.places.back());
    trail.places.pop_back();
    trail.to = to.path;
    return goBack(workspace, std::move(to));
}

void playSceneBehind(Workspace& workspace, bool paused) {
    while (editsPrefab(workspace)) {
        if (const Result<LoadReport> back = leavePrefab(workspace); !back) {
            workspace.notice = "No scene to play; a prefab cannot be played without a scene";
            return;
        }
    }
    workspace.startPlaying(paused);
}

void askToEditPrefab(Workspace& workspace, std::string path) {
    trailOf(workspace).asked = PrefabVisit{PrefabVisit::Kind::Edit, std::move(path)};
}

void askToLeavePrefab(Workspace& workspace) {
    trailOf(workspace).asked = PrefabVisit{PrefabVisit::Kind::Leave, {}};
}

void askToPlayScene(Workspace& workspace, bool paused) {
    trailOf(workspace).asked =
        PrefabVisit{paused ? PrefabVisit::Kind::PlayPaused : PrefabVisit::Kind::Play, {}};
}

std::optional<PrefabVisit> takePrefabVisit(Workspace& workspace) {
    if (workspace.document.world.findResource<Trail>() == nullptr) return std::nullopt;
    return std::exchange(trailOf(workspace).asked, std::nullopt);
}

void go(Workspace& workspace, const PrefabVisit& visit) {
    switch (visit.kind) {
        case PrefabVisit::Kind::Edit:
            workspace.stopPlaying();
            static_cast<void>(editPrefab(workspace, visit.path).ok());
            break;
        case PrefabVisit::Kind::Leave: static_cast<void>(leavePrefab(workspace).ok()); break;
        case PrefabVisit::Kind::Play:
        case PrefabVisit::Kind::PlayPaused:
            playSceneBehind(workspace, visit.kind == PrefabVisit::Kind::PlayPaused);
            break;
    }
}

}  // namespace plumb::editor
