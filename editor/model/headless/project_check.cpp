#include "editor/model/headless/project_check.hpp"

#include <set>

#include "app/project.hpp"
#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/assets/asset_uses.hpp"
#include "editor/model/headless/asset_content.hpp"
#include "editor/model/headless/asset_names.hpp"
#include "editor/model/workspace.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {
namespace {

std::string counted(std::size_t count, std::string_view one) {
    return format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// Collects problems without duplicates: an image missing in several scenes is reported once.
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

/// Adds to a problem with a file the place that references it, where the user can fix it.
Error withNamers(const Path& root, const AssetNames& names, Error problem) {
    std::string user = names.usersOf(problem.where);
    if (user.empty()) {
        const std::vector<AssetUse> uses = usesOfAsset(root, problem.where, false);
        if (!uses.empty()) user = uses.front().file;
    }
    if (!user.empty()) problem.what += format(", referenced by {}", user);
    return problem;
}

Result<Done> contentOf(const Path& root, const AssetItem& file) {
    const bool looked =
        file.kind == AssetKind::Texture || file.kind == AssetKind::Sound || file.kind == AssetKind::Font;
    if (!looked) return Done{};
    const Result<std::string> bytes = readFile(root / file.path);
    return bytes ? checkContent(file.kind, *bytes, file.path) : Result<Done>{bytes.error()};
}

/// Checks all assets, referenced and unreferenced ones.
void checkAssets(const Path& root, Workspace& workspace, ProjectCheck& check, Problems& problems,
                 PrefabLibrary& prefabs) {
    AssetNames names{workspace.document.types()};
    AssetCatalog catalog{root};
    catalog.refresh();
    for (const AssetItem& file : catalog.all()) {
        if (file.kind == AssetKind::Prefab) {
            ++check.prefabs;
            if (const auto prefab = prefabs.find(file.path); !prefab) problems.add(prefab.error());
        } else if (file.kind != AssetKind::None && file.kind != AssetKind::Scene) {
            ++check.assets;
            workspace.assets.load(file.kind, file.path);
        }
        if (file.kind != AssetKind::Prefab && file.kind != AssetKind::Scene) continue;
        if (const Result<std::string> text = readFile(root / file.path)) names.read(file.path, *text);
    }
    problems.add(prefabs.takeProblems());
    // Includes assets referenced by prefabs that no scene uses.
    for (const auto& [path, named] : names.all()) workspace.assets.load(named.kind, path);
    std::set<std::string> reported;
    for (const Error& problem : workspace.assets.errors()) {
        reported.insert(problem.where);
        problems.add(withNamers(root, names, problem));
    }
    for (const AssetItem& file : catalog.all()) {
        if (reported.count(file.path) != 0) continue;
        if (const Result<Done> good = contentOf(root, file); !good)
            problems.add(withNamers(root, names, good.error()));
    }
}

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
    check.warnings = check.problems.size();
    for (const std::string& path : workspace.scenes()) {
        ++check.scenes;
        const Result<LoadReport> report = workspace.open(path);
        if (report) {
            problems.add(report->problems);
        } else {
            problems.add(report.error());
        }
    }
    if (!project.startScene.empty() && !std::filesystem::exists(project.root / project.startScene)) {
        problems.add(Error{"project.json: startScene", format("{} does not exist", project.startScene),
                           "set it to an existing scene"});
    }
    checkAssets(project.root, workspace, check, problems, prefabs);
    return check;
}

}  // namespace plumb::editor
