#include "editor/model/project/project_session.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/converted_values.hpp"
#include "editor/model/assets/reload_document.hpp"
#include "editor/model/headless/project_check.hpp"
#include "editor/model/headless/project_export.hpp"
#include "editor/model/headless/windows_resources.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/model/play/replay_in_scene.hpp"
#include "editor/model/project/script_definitions.hpp"
#include "import/import_file.hpp"
#include "platform/paths.hpp"
#include "scene/files/scene_path.hpp"

namespace plumb::editor {
namespace {

#if defined(_WIN32)
constexpr const char* kEditorProgram = "plumb-editor.exe";
#else
constexpr const char* kEditorProgram = "plumb-editor";
#endif

/// Prints the error, if there is one. Returns the exit code of the program.
int endWith(const Result<Done>& done) {
    if (done) return 0;
    std::fprintf(stderr, "plumb-editor: %s\n", done.error().text().c_str());
    return 1;
}

}  // namespace

ProjectSession::ProjectSession(Project project)
    : project_{std::move(project)},
      code_{project_.root},
      scripts_{content_.scripts(), project_.root},
      assets_{project_.root, engineAssets()},
      prefabs_{content_.types(), project_.root} {
    content_.readScripts(project_.root, scriptProblems_);
    writeScriptDefinitions(project_.root, content_);
    ProjectFolder folder{project_.root,
                         project_.name,
                         {static_cast<float>(project_.width), static_cast<float>(project_.height)},
                         project_.smooth,
                         project_.layers};
    workspace_ = std::make_unique<Workspace>(content_.types(), assets_, std::move(folder), &prefabs_);
    workspace_->program = executableFolder() / kEditorProgram;
    workspace_->makeSession = [this](const std::string& path, const std::string& text) {
        if (const Result<Project> now = loadProject(project_.root)) project_.actions = now->actions;
        return makeGameSession(project_, path, text, content_);
    };
    workspace_->document.world.provide(content_.effects());
    content_.scripts().addTexts(workspace_->document.world);
    workspace_->followCode = [this](double now) { followCode(now), followScripts(now); };
}

void ProjectSession::followCode(double now) {
    const bool wasBuilding = code_.isBuilding();
    const bool hasNewLibrary = code_.poll(now);
    if (code_.isBuilding() && !wasBuilding)
        workspace_->notice = replay_ ? "Building the code of the project; then the replay begins..."
                                     : "Building the code of the project...";
    bool usable = code_.succeeded() && codeProblems_.empty();
    if (hasNewLibrary) {
        usable = loadCodeAndReport();
        workspace_->notice = "Reloaded the code of the project";
        logNote("Code", "{}", workspace_->notice);
    }
    const bool ended = wasBuilding && !code_.isBuilding();
    if (!ended || !replay_) return;
    if (usable) return beginReplay();
    workspace_->notice = "The replay waits: the code of the project has an error, see the Console";
}

/// Plays the replay that has waited for the code.
void ProjectSession::beginReplay() {
    const Replay replay = *std::exchange(replay_, {});
    Result<Done> played = Done{};
    if (workspace_->play.running() || workspace_->document.scenePath != replayScene_)
        played =
            Error{replayFile_, "not played: another scene or game runs by now", "start the editor again"};
    else
        played = playReplayInScene(*workspace_, replay, replayFile_);
    if (!played) {
        workspace_->notice = played.error().text();
        return logError("Editor", played.error());
    }
    logNote("Editor", "{}", workspace_->notice);
}

bool ProjectSession::loadCode() {
    Result<Module> code = code_.load();
    if (!code) {
        logError("Code", code.error());
        return false;
    }
    useCode(*std::move(code));
    return true;
}

bool ProjectSession::loadCodeAndReport() {
    if (!loadCode()) return false;
    for (const Error& problem : codeProblems_) logError("Code", problem);
    return codeProblems_.empty();
}

void ProjectSession::useCode(Module code) {
    codeProblems_.clear();
    change([&] { return content_.update(std::move(code), codeProblems_); });
}

void ProjectSession::followScripts(double now) {
    if (!scripts_.poll(now)) return;
    scriptProblems_.clear();
    change([&] { return content_.readScripts(project_.root, scriptProblems_); });
    for (const Error& problem : scriptProblems_) logError("Script", problem);
    workspace_->notice =
        scriptProblems_.empty() ? "Reloaded the scripts" : "A script has an error: see the Console";
}

void ProjectSession::change(const std::function<ContentChange()>& update) {
    Workspace& w = *workspace_;
    const bool isOpen = !w.document.scenePath.empty();
    const bool unsaved = w.unsaved();
    const std::string text = isOpen ? w.text() : std::string{};
    w.play.leaveTick();  // before the types of its snapshot change
    w.safety.finish();   // it writes a copy of the scene in its own thread
    // Copies of the game whose worlds are not converted.
    w.reach.clear();
    w.trajectories.clear();
    const ContentChange change = update();
    writeScriptDefinitions(project_.root, content_);
    prefabs_.forget();
    convertWorld(w.document.world, content_, change);
    if (w.play.running()) w.play.contentChanged(change);
    // The scene's text also contains components of types that the old or the new version does not know.
    const bool reread = isOpen && (!change.added.empty() || !change.types.empty());
    const ConvertedValues converted{w.document, change};
    if (reread) {
        const SceneContext context{content_.types(), &prefabs_, project_.root};
        if (const Result<LoadReport> loaded = reloadDocument(w.document, context, text); !loaded)
            logError("Editor", loaded.error());
    }
    const bool differs = converted.restore(w.document);
    if (change.types.empty()) return;
    w.undo.clear();
    if (unsaved || differs) w.undo.markUnsaved();
}

Result<std::unique_ptr<ProjectSession>> ProjectSession::open(const std::string& folder) {
    Result<Project> project = loadProject(folder);
    if (!project) return project.error();
    return open(*std::move(project));
}

std::unique_ptr<ProjectSession> ProjectSession::open(Project project) {
    for (const Error& warning : project.warnings) {
        logWarning("Project", warning);
    }
    return std::unique_ptr<ProjectSession>{new ProjectSession{std::move(project)}};
}

std::unique_ptr<ProjectSession> ProjectSession::none() {
    Project project;
    project.root = configFolder() / "no project";  // does not exist, and nothing is written there
    project.name = "Welcome";
    std::unique_ptr<ProjectSession> session{new ProjectSession{std::move(project)}};
    session->workspace().project.isNone = true;
    return session;
}

void ProjectSession::openFirst(std::string_view scene) {
    if (code_.isBuilt()) loadCodeAndReport();
    for (const Error& problem : scriptProblems_) logError("Script", problem);
    const std::vector<std::string> scenes = workspace_->scenes();
    const std::string wanted = scenePath(scene.empty() ? std::string_view{project_.startScene} : scene);
    if (std::find(scenes.begin(), scenes.end(), wanted) != scenes.end()) {
        static_cast<void>(workspace_->open(wanted).ok());
        return;
    }
    if (!scene.empty()) workspace_->notice = format("The project has no scene \"{}\"", scene);
    if (!scenes.empty() && scene.empty()) static_cast<void>(workspace_->open(scenes.front()).ok());
}

Result<Done> ProjectSession::openReplay(const std::string& file, bool builds) {
    Result<Replay> replay = loadReplay(file);
    if (!replay) return replay.error();
    if (Result<Done> checked = checkReplay(*workspace_, *replay, file); !checked) return checked;
    if (builds && code_.canBuild() && !buildCode())
        return Error{project_.root.generic_string(), "its code has errors", "mend them, see above"};
    openFirst(replay->scene);
    if (builds || !code_.canBuild()) return playReplayInScene(*workspace_, *replay, file);
    replay_ = std::move(*replay);
    replayFile_ = file;
    replayScene_ = workspace_->document.scenePath;
    return Done{};
}

bool ProjectSession::buildCode() {
    if (!code_.exists()) return true;
    std::printf("Building the code...\n");
    return code_.buildNow() && loadCode();
}

ProjectCheck ProjectSession::check() {
    ProjectCheck found = checkProject(project_, *workspace_, prefabs_);
    for (const ScriptSet::File& script : content_.scripts().files())
        found.problems.insert(found.problems.end(), script.warnings.begin(), script.warnings.end());
    for (const std::vector<Error>* problems : {&codeProblems_, &scriptProblems_}) {
        const auto first = found.problems.begin() + static_cast<std::ptrdiff_t>(found.warnings);
        found.problems.insert(first, problems->begin(), problems->end());
    }
    return found;
}

int ProjectSession::validate() {
    if (!buildCode()) return 1;
    const ProjectCheck found = check();
    std::printf("%s", found.text().c_str());
    return found.problems.empty() ? 0 : 1;
}

int ProjectSession::exportGame(const EditorOptions& options) {
    if (!options.finished.empty()) return endWith(placeExport(project_, options.finished, options.exportTo));
    if (!buildCode()) return 1;
    const ProjectCheck found = check();
    std::printf("%s", found.text().c_str());
    if (const std::size_t errors = found.errors(); errors > 0) {
        std::fprintf(stderr,
                     "plumb-editor: nothing was exported: fix the %zu problem%s first; the lines above, "
                     "./plumb edit and "
                     "--validate show %s\n",
                     errors, errors == 1 ? "" : "s", errors == 1 ? "it" : "them");
        return 1;
    }
    const Path player = options.player.empty() ? playerOf(project_.root) : Path{options.player};
    const Result<ExportReport> report =
        exportProject(project_, options.exportTo, {player, engineAssets(), options.licences});
    if (!report) {
        std::fprintf(stderr, "plumb-editor: %s\n", report.error().text().c_str());
        return 1;
    }
    std::printf("The largest of %zu files:\n", report->files);
    for (const std::string& file : report->largest) std::printf("  %s\n", file.c_str());
    for (const std::string& file : report->written) std::printf("Wrote %s\n", file.c_str());
    std::printf("Exported \"%s\": %s MB in %s; start it with \"%s\" in this folder\n",
                fileNameOf(project_.name).c_str(),
                fixedText(static_cast<double>(report->bytes) / 1e6, 1).c_str(), options.exportTo.c_str(),
                report->program.c_str());
    return 0;
}

int ProjectSession::writeResources(const Path& folder) const {
    return endWith(writeWindowsResources(project_, folder));
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
