#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "editor/model/debug/script_debugger.hpp"
#include "editor/model/debug/script_view.hpp"
#include "editor/model/document/document.hpp"
#include "editor/model/document/undo_stack.hpp"
#include "editor/model/overlays/reach_view.hpp"
#include "editor/model/overlays/trajectories.hpp"
#include "editor/model/play/keep_changes.hpp"
#include "editor/model/play/play_mode.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"
#include "editor/model/profiler/profiler.hpp"
#include "editor/model/project/settings.hpp"
#include "editor/model/safety/safety_net.hpp"
#include "editor/model/tools/tool.hpp"
#include "editor/model/view/view_camera.hpp"
#include "editor/model/view/view_file.hpp"
#include "math/color.hpp"
#include "scene/drawing/physics_view.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/physics/physics_times.hpp"

namespace plumb::editor {

/// Settings of the open project that the editor uses.
struct ProjectFolder {
    Path root;
    std::string name = "Untitled";
    Vec2 picture{640.0f, 360.0f};       ///< size of the game's viewport, px
    bool smooth = false;                ///< linear texture filter (drawings) instead of nearest (pixel art)
    std::vector<std::string> layers{};  ///< names of the collision layers, lowest bit first
    bool isNone = false;                ///< no project is open; the welcome screen is shown
};

/// Request of an action to the editor's window, e.g. to open a dialog.
enum class WindowRequest : unsigned char {
    None,
    ChooseScene,
    NameNewScene,
    NameSceneCopy,
    ChoosePrefab,
    ChooseBackup,
    Quit,
    LargerText,
    SmallerText,
    RenameSelected,
    Import,
    Export,
    FindFile,
    FindCommand,
    NamePrefab,
    ShowOverrides,
    Preferences,
    Welcome,
    OpenProject,
    NameLayout
};

/// Positions to which moved entities snap.
enum class SnapTo : unsigned char { Grid, HalfGrid, Pixel };

struct GridSettings {
    Vec2 size{16.0f, 16.0f};  ///< cell size, px
    bool snap = true;         ///< moved entities snap to multiples of `step()`
    SnapTo to = SnapTo::Grid;
    bool snapAngles = true;    ///< if `snap` too: rotations snap to multiples of `angle`
    float angle = kSnapAngle;  ///< rotation step, rad
    Color color = kGridColor;  ///< color of the grid lines
    static constexpr float kSnapAngle = 0.2617993878f;  ///< rad: 15 degrees
    static constexpr Color kGridColor{255, 255, 255, 16};

    /// Distance between neighboring snap positions, px.
    [[nodiscard]] Vec2 step() const {
        return to == SnapTo::Pixel ? Vec2{1.0f, 1.0f} : to == SnapTo::HalfGrid ? size * 0.5f : size;
    }
};

/// State of one editor without its window: the project, the open scene, tools, settings and the running game.
class Workspace {
public:
    Workspace(const TypeRegistry& types, AssetStore& assets, ProjectFolder folder,
              PrefabLibrary* prefabs = nullptr);
    ~Workspace() { safety.leaving(); }
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    ProjectFolder project;
    AssetStore& assets;
    Document document;
    UndoStack undo;
    ViewCamera view;
    PhysicsTimes physicsTimes;  ///< durations of the physics stages in the running game
    PlayMode play;
    ScriptDebugger debugger{play};
    ScriptView scripts{*this};  ///< data of the panel Scripts
    Profiler profiler{physicsTimes};
    bool followsGame =
        true;  ///< the view follows the running game's camera; panning or zooming turns this off
    GridSettings grid;
    TilePaint tiles;                                      ///< state shared by the tile tools
    Settings settings;                                    ///< user settings, for all projects
    PhysicsView physics;                                  ///< layers of physics debug drawing
    std::vector<std::string> overlays{"grid", "camera"};  ///< names of the overlays shown for all entities
    std::vector<std::string> overlaysOfSelected;          ///< names of overlays for selected entities only
    std::string clipboard;                                ///< text of the system's clipboard
    std::string notice;                                   ///< status bar text: the last action or error
    WindowRequest request = WindowRequest::None;
    std::string importFrom;     ///< file for WindowRequest::Import; empty: the user chooses one
    std::string projectToOpen;  ///< project folder for WindowRequest::OpenProject
    std::string assetToEdit;    ///< path of a file to open in the panel for its kind
    std::string panelToShow;    ///< title of a panel to bring to the front
    std::string assetToShow;    ///< path of a file to show in the asset browser
    /// Starts a game from a scene's path and its text including unsaved changes.
    std::function<std::unique_ptr<PlaySession>(const std::string& path, const std::string& text)> makeSession;
    /// Called in every frame, if set: rebuilds and reloads changed project code. @param now  s, of any clock
    std::function<void(double now)> followCode;
    Path program;                           ///< the program plumb-editor, which exports the project
    std::function<InputFrame()> gameInput;  ///< returns the current input for the game

    // Scene file.

    Result<LoadReport> open(std::string_view path);
    /// Opens a scene from `text` instead of its file, as a scene with unsaved changes.
    Result<LoadReport> openText(std::string_view path, const std::string& text);
    /// Writes an empty scene and opens it.
    /// @param name  file name in scenes/, without extension
    /// @error       the name is not valid, or a scene of that name exists
    Result<Done> createScene(std::string_view name);
    Result<Done> save();
    /// Writes the open scene to a new file, which then is the open scene; the old file stays as it is. The
    /// undo history is kept.
    /// @param name  file name in scenes/, without extension
    /// @error       the name is not valid, a scene of that name exists, or no scene is open
    Result<Done> saveAs(std::string_view name);
    /// Frames the area that the scene's camera shows, at the largest pixel-perfect zoom; without a camera,
    /// all entities.
    void showStart();
    [[nodiscard]] bool unsaved() const { return !undo.isSaved(); }
    [[nodiscard]] std::vector<std::string> scenes() const;
    [[nodiscard]] std::string text() const;  ///< the scene as it would be saved

    // Tools.

    [[nodiscard]] Tool& tool() { return *tools_[tool_]; }
    [[nodiscard]] const Tool& tool() const { return *tools_[tool_]; }
    [[nodiscard]] std::size_t toolIndex() const { return tool_; }
    void useTool(std::size_t index);
    void useTool(std::string_view action);
    [[nodiscard]] ToolContext tools() { return {document, undo, document.selection, tiles}; }
    /// True if the tool has selected a part of the edited entity (e.g. a corner) that Del would remove.
    [[nodiscard]] bool hasSelectedPart() const {
        return tool().hasSelectedPart(
            const_cast<Workspace*>(this)->tools());  // does not change the workspace
    }
    [[nodiscard]] bool paintsTiles() const { return toolTable()[tool_].forTiles; }

    // Prefabs.

    [[nodiscard]] PrefabEdit prefabs() { return {document, undo, prefabs_, project.root}; }
    /// Paths of all prefab files of the project.
    [[nodiscard]] std::vector<std::string> prefabFiles() const;
    /// True if one of the selected entities is an instance of a prefab or a part of one.
    [[nodiscard]] bool selectsInstance() const;
    void revertToPrefab(const PrefabScope& scope = {});  ///< resets the selected entities to their prefabs
    void applyToPrefab(const PrefabScope& scope = {});   ///< writes the selection's overrides to its prefabs

    // Playing.

    /// The world shown in the viewport: that of the running game, or the document's.
    [[nodiscard]] World& shownWorld() { return play.running() ? play.world() : document.world; }
    [[nodiscard]] const World& shownWorld() const { return play.running() ? play.world() : document.world; }
    /// Maps between ObjectIds and the entities of the shown world.
    [[nodiscard]] const ObjectNames& shownNames() const {
        return play.running() ? static_cast<const ObjectNames&>(play) : document;
    }
    [[nodiscard]] EntityId shownEntity(ObjectId id) const { return shownNames().find(id); }
    void togglePlay();
    /// @param paused  true: the game pauses before its first tick
    void startPlaying(bool paused = false);
    /// Stops the game. Changes that the user made while it ran are then in `offeredChanges`.
    void stopPlaying();
    std::vector<KeepRow> offeredChanges;  ///< changes from the stopped game that the user may keep
    /// Applies the ticked rows of `offeredChanges` to the scene and clears the list.
    void keepTicked();
    [[nodiscard]] bool canEdit() const { return !play.running(); }

    /// Updates background work: the journal, and overlays that are computed over several frames. Must be
    /// called once per frame. @param seconds  since the last call
    void update(double seconds);

    [[nodiscard]] bool shows(std::string_view overlay) const { return reachOf(overlay) != PhysicsReach::Off; }
    void toggleOverlay(std::string_view overlay);
    /// Entities for which an overlay is shown: all, the selected ones, or none.
    [[nodiscard]] PhysicsReach reachOf(std::string_view overlay) const;
    void setReach(std::string_view overlay, PhysicsReach whose);  ///< sets what `reachOf` returns
    ReachView reach;                                              ///< data of the overlay "reach"
    Trajectories trajectories;                                    ///< data of the overlay "trajectories"

    ViewFile viewFile{project.root};  ///< stores hidden and locked entities between sessions
    SafetyNet safety{*this};          ///< journal of unsaved changes and watch on the scene's file

private:
    [[nodiscard]] SceneContext context() const;
    Result<LoadReport> load(const std::string& path, const std::string* text);
    Result<Done> write();

    PrefabLibrary* prefabs_;
    std::vector<std::unique_ptr<Tool>> tools_;
    std::size_t tool_ = 0;
};

}  // namespace plumb::editor
