#include "editor/model/project/project_session.hpp"

#include <algorithm>
#include <cstdio>

#include "app/engine_types.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/headless/project_check.hpp"
#include "editor/model/headless/project_export.hpp"
#include "editor/model/play/game_session.hpp"
#include "import/import_file.hpp"
#include "platform/paths.hpp"

namespace plumb::editor {

ProjectSession::ProjectSession(Project project)
    : project_{std::move(project)},
      types_{engineTypes()},
      assets_{project_.root, engineAssets()},
      prefabs_{types_, project_.root} {
    ProjectFolder folder{project_.root,
                         project_.name,
                         {static_cast<float>(project_.width), static_cast<float>(project_.height)},
                         project_.smooth,
                         project_.layers};
    workspace_ = std::make_unique<Workspace>(types_, assets_, std::move(folder), &prefabs_);
    workspace_->makeSession = [this](const std::string& path, const std::string& text) {
        if (const Result<Project> now = loadProject(project_.root)) project_.actions = now->actions;
        return makeGameSession(project_, path, text);
    };
}

Result<std::unique_ptr<ProjectSession>> ProjectSession::open(const std::string& folder) {
    Result<Project> project = loadProject(folder);
    if (!project) return project.error();
    for (const Error& warning : project->warnings) {
        logWarning("Project", warning);
    }
    return std::unique_ptr<ProjectSession>{new ProjectSession{*std::move(project)}};
}

std::unique_ptr<ProjectSession> ProjectSession::none() {
    Project project;
    project.root = configFolder() / "no project";  // nothing is there, and nothing is written there
    project.name = "Welcome";
    std::unique_ptr<ProjectSession> session{new ProjectSession{std::move(project)}};
    session->workspace().project.isNone = true;
    return session;
}

void ProjectSession::openFirst(std::string_view scene) {
    const std::vector<std::string> scenes = workspace_->scenes();
    const std::string wanted{scene.empty() ? std::string_view{project_.startScene} : scene};
    for (const std::string& path : {wanted, "scenes/" + wanted, "scenes/" + wanted + ".scene.json"}) {
        if (std::find(scenes.begin(), scenes.end(), path) == scenes.end()) continue;
        static_cast<void>(workspace_->open(path).ok());
        return;
    }
    if (!scene.empty()) workspace_->notice = format("There is no scene \"{}\"", scene);
    if (!scenes.empty() && scene.empty()) static_cast<void>(workspace_->open(scenes.front()).ok());
}

int ProjectSession::validate() {
    const ProjectCheck check = checkProject(project_, *workspace_, prefabs_);
    std::printf("%s", check.text().c_str());
    return check.problems.empty() ? 0 : 1;
}

int ProjectSession::exportTo(const std::string& folder) {
    const ProjectCheck check = checkProject(project_, *workspace_, prefabs_);
    std::printf("%s", check.text().c_str());
    if (!check.playable) {
        std::fprintf(stderr, "plumb-editor: nothing was exported; mend the scenes first\n");
        return 1;
    }
#if defined(_WIN32)
    constexpr const char* kPlayer = "plumb-player.exe";
#else
    constexpr const char* kPlayer = "plumb-player";
#endif
    const Result<ExportReport> report =
        exportProject(project_.root, folder, {executableFolder() / kPlayer, engineAssets()});
    if (!report) {
        std::fprintf(stderr, "plumb-editor: %s\n", report.error().text().c_str());
        return 1;
    }
    std::printf("Exported %zu files, %s MB, to %s%s\n", report->files,
                fixedText(static_cast<double>(report->bytes) / 1e6, 1).c_str(), folder.c_str(),
                report->runnable ? "; its program is play" : "; plumb-player FOLDER/game plays it");
    return 0;
}

int importFile(const EditorOptions& options) {
    const Result<ImportReport> report =
        plumb::importFile(options.importFrom, options.importTo, options.project);
    if (!report) {
        std::fprintf(stderr, "plumb-editor: %s\n", report.error().text().c_str());
        return 1;
    }
    std::printf("%s", report->text().c_str());
    return 0;
}

}  // namespace plumb::editor
