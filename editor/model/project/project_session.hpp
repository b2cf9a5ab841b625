#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/game_content.hpp"
#include "app/project.hpp"
#include "app/reload/script_watch.hpp"
#include "assets/asset_store.hpp"
#include "editor/model/headless/project_check.hpp"
#include "editor/model/project/editor_options.hpp"
#include "editor/model/project/project_code.hpp"
#include "editor/model/workspace.hpp"
#include "input/recorder.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {

/// A project that is open in the editor: its types, assets and prefabs, and the workspace on top of them.
class ProjectSession {
public:
    /// Opens a project.
    /// @param folder  the project's folder
    /// @error         the folder has no valid project.json
    static Result<std::unique_ptr<ProjectSession>> open(const std::string& folder);
    /// Opens a project whose file was read. Only one session may be open if their components have equal
    /// names.
    static std::unique_ptr<ProjectSession> open(Project project);
    /// Creates an empty session without a project, for the welcome screen.
    static std::unique_ptr<ProjectSession> none();

    [[nodiscard]] Workspace& workspace() { return *workspace_; }
    [[nodiscard]] AssetStore& assets() { return assets_; }

    /// Loads the project's code if it is built, and opens the scene of this name; if `scene` is empty, the
    /// project's start scene, or its first scene if it has no start scene.
    void openFirst(std::string_view scene);

    /// Opens the first scene of a replay and plays it there: playReplayInScene(). If the project has code,
    /// the replay begins when the code is built and loaded, as followCode() of the workspace notices; errors
    /// are logged then.
    /// @param builds  build the code in this call: nothing will call followCode()
    /// @error the file is no replay or one of another project, the code has errors, the replay fails
    Result<Done> openReplay(const std::string& file, bool builds);

    /// Builds the code, checks it and all scenes, prefabs and assets, and prints the problems. @return exit
    /// code of the program
    int validate();
    /// Exports the project as a game that runs without the editor, as the options say. @return exit code of
    /// the program
    int exportGame(const EditorOptions& options);
    /// Writes the resources of the program for Windows: writeWindowsResources(). @return exit code
    int writeResources(const Path& folder) const;

    /// Replaces the project's code by another version, in the open scene and in a running game too:
    /// components keep the values of the fields that both versions have. If fields of a component differ, the
    /// undo history is cleared. Errors in the description of the code are kept, see codeProblems().
    void useCode(Module code);
    [[nodiscard]] const std::vector<Error>& codeProblems() const { return codeProblems_; }

private:
    explicit ProjectSession(Project project);

    void followCode(double now);
    void beginReplay();
    /// Reads the script files again when one of them has changed.
    void followScripts(double now);
    /// Updates content_, then the open scene and a running game.
    void change(const std::function<ContentChange()>& update);
    bool loadCode();
    bool loadCodeAndReport();
    bool buildCode();
    ProjectCheck check();

    Project project_;
    std::vector<Error> codeProblems_;
    std::vector<Error> scriptProblems_;
    GameContent content_{{}, codeProblems_};
    ProjectCode code_;
    ScriptWatch scripts_;
    std::optional<Replay> replay_;  // begins when the code was built
    std::string replayFile_;
    std::string replayScene_;  // path of the scene that was opened for it
    AssetStore assets_;
    PrefabLibrary prefabs_;
    std::unique_ptr<Workspace> workspace_;
};

/// Imports a file of Tiled, LDtk or Aseprite as scenes or animations with their assets, and prints a report.
/// @return exit code of the program
int importFile(const EditorOptions& options);

}  // namespace plumb::editor
