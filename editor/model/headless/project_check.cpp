#include "editor/model/headless/project_check.hpp"

#include <set>

#include "app/project.hpp"
#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/workspace.hpp"
#include "scene/prefab.hpp"

namespace plumb::editor {
namespace {

std::string counted(std::size_t count, std::string_view one) {
    return format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// Keeps each problem once: a picture that is missing is missing in every scene.
class Problems {
public:
    explicit Problems(ProjectCheck& check) : check_{check} {}
    void add(const Error& problem) {
        if (known_.insert(problem.text()).second) check_.problems.push_back(problem);
    }
    void add(const std::vector<Error>& problems) {
        for (const Error& problem : problems) add(problem);
    }

private:
    ProjectCheck& check_;
    std::set<std::string> known_;
};

}  // namespace

std::string ProjectCheck::text() const {
    std::string lines;
    for (const Error& problem : problems) lines += problem.text() + "\n";
    return lines + format("{}, {}, {}: {}\n", counted(scenes, "scene"), counted(prefabs, "prefab"),
                          counted(assets, "asset"), counted(problems.size(), "problem"));
}

ProjectCheck checkProject(const Project& project, Workspace& workspace, PrefabLibrary& prefabs) {
    ProjectCheck check;
    Problems problems{check};
    problems.add(project.warnings);
    for (const std::string& path : workspace.scenes()) {
        ++check.scenes;
        const Result<LoadReport> report = workspace.open(path);
        if (report) {
            problems.add(report->problems);
        } else {
            problems.add(report.error());
            check.playable = false;
        }
    }
    if (!project.startScene.empty() && !std::filesystem::exists(project.root / project.startScene)) {
        problems.add(Error{"project.json: startScene", format("there is no {}", project.startScene),
                           "name a scene that there is"});
        check.playable = false;
    }
    AssetCatalog catalog{project.root};
    catalog.refresh();
    for (const AssetItem& file : catalog.all()) {
        if (file.kind == AssetKind::Prefab) {
            ++check.prefabs;
            if (const auto prefab = prefabs.find(file.path); !prefab) problems.add(prefab.error());
        } else if (file.kind != AssetKind::None && file.kind != AssetKind::Scene) {
            ++check.assets;
            workspace.assets.load(file.kind, file.path);
        }
    }
    problems.add(workspace.assets.errors());
    return check;
}

}  // namespace plumb::editor
