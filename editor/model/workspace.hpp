#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/file.hpp"
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

/// What the editor knows of the project that it has open.
struct ProjectFolder {
    Path root;
    std::string name = "Untitled";
    Vec2 picture{640.0f, 360.0f};       ///< px of the game's own picture
    bool smooth = false;                ///< its pictures are drawings, not pixel art
    std::vector<std::string> layers{};  ///< names of the layers of collisions, from the lowest bit on
    bool isNone = false;                ///< no project is open: the welcome screen
};

/// What only the window can do; set by an action, taken by the window.
enum class WindowRequest : unsigned char {
    None,
    ChooseScene,
    NameNewScene,
    ChoosePrefab,
    ChooseBackup,
    Quit,
    LargerText,
    SmallerText,
    RenameSelected,
    Import,
    FindFile,
    FindCommand,
    NamePrefab,
    ShowOverrides,
    Preferences,
    Welcome,
    OpenProject,
    NameLayout
};

/// What things come to when they are moved with snapping.
enum class SnapTo : unsigned char { Grid, HalfGrid, Pixel };

struct GridSettings {
    Vec2 size{16.0f, 16.0f};  ///< px
    bool snap = true;
    SnapTo to = SnapTo::Grid;
    bool snapAngles = true;                             ///< with `snap`: turning goes in steps
    float angle = kSnapAngle;                           ///< rad, of one step
    Color color = kGridColor;                           ///< of its lines
    static constexpr float kSnapAngle = 0.2617993878f;  ///< rad: 15 degrees
    static constexpr Color kGridColor{255, 255, 255, 16};

    /// px between two places that things come to.
    [[nodiscard]] Vec2 step() const {
        return to == SnapTo::Pixel ? Vec2{1.0f, 1.0f} : to == SnapTo::HalfGrid ? size * 0.5f : size;
    }
};

/// Everything that is open in one editor, without the window around it.
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
    PhysicsTimes physicsTimes;  ///< of the game that plays
    PlayMode play;
    Profiler profiler{physicsTimes};
    bool followsGame =
        true;  ///< the view goes with the camera of the game that plays, until it is moved by hand
    GridSettings grid;
    TilePaint tiles;
    Settings settings;                                    ///< of the person, whatever the project
    PhysicsView physics;                                  ///< what of it is shown over the scene
    std::vector<std::string> overlays{"grid", "camera"};  ///< those that are shown, by name
    std::vector<std::string> overlaysOfSelected;          ///< those that are shown of what is selected
    std::string clipboard;
    std::string notice;  ///< what was done last, for the status bar
    WindowRequest request = WindowRequest::None;
    std::string importFrom;     ///< with WindowRequest::Import: the file; empty: the person chooses
    std::string projectToOpen;  ///< with WindowRequest::OpenProject: its folder
    std::string assetToEdit;    ///< path of a file that the panel for its kind shall open
    std::string panelToShow;    ///< title of a panel that comes to the front
    std::string assetToShow;    ///< path of a file that the asset browser shall show
    /// How this program plays a scene, given its path and its text with all changes.
    std::function<std::unique_ptr<PlaySession>(const std::string& path, const std::string& text)> makeSession;
    std::function<InputFrame()> gameInput;  ///< what the player's hands do now

    // The scene file.

    Result<LoadReport> open(std::string_view path);
    /// Opens a scene with another text than its file has: as if that had been changed and not saved.
    Result<LoadReport> openText(std::string_view path, const std::string& text);
    /// Writes an empty scene and opens it.
    /// @param name  of its file in scenes/, without ending
    /// @error       no name, one that leaves the folder, or there is such a scene
    Result<Done> createScene(std::string_view name);
    Result<Done> save();
    /// Looks at all that the scene's camera sees, as large as whole pixels allow; without a camera, at all
    /// there is.
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
    /// Whether the tool has a part of the thing in hand that Del would take out.
    [[nodiscard]] bool hasChosen() const {
        return tool().hasChosen(const_cast<Workspace*>(this)->tools());  // only looks
    }
    [[nodiscard]] bool paintsTiles() const { return toolTable()[tool_].forTiles; }

    // Prefabs.

    [[nodiscard]] PrefabEdit prefabs() { return {document, undo, prefabs_, project.root}; }
    [[nodiscard]] std::vector<std::string> prefabFiles() const;
    /// Whether one of the selected entities comes from a prefab.
    [[nodiscard]] bool selectsInstance() const;
    void revertToPrefab(const PrefabScope& scope = {});  ///< what is selected
    void applyToPrefab(const PrefabScope& scope = {});   ///< of the entity selected last

    // Playing.

    /// The world to look at: the one that plays, or the document's.
    [[nodiscard]] World& shownWorld() { return play.running() ? play.world() : document.world; }
    [[nodiscard]] const World& shownWorld() const { return play.running() ? play.world() : document.world; }
    /// Which entity of the shown world an object is.
    [[nodiscard]] const ObjectNames& shownNames() const {
        return play.running() ? static_cast<const ObjectNames&>(play) : document;
    }
    [[nodiscard]] EntityId shownEntity(ObjectId id) const { return shownNames().find(id); }
    void togglePlay();
    /// @param paused  before the first tick
    void startPlaying(bool paused = false);
    /// What was changed by hand meanwhile is then in `toKeep`.
    void stopPlaying();
    std::vector<KeepRow> toKeep;  ///< offered after the game stopped
    /// Takes the ticked ones over into the scene, and forgets the list.
    void keepTicked();
    [[nodiscard]] bool canEdit() const { return !play.running(); }

    /// What goes on by itself: the journal, overlays that are found out bit by bit. To be called in every
    /// frame. @param seconds  since the last one
    void tend(double seconds);

    [[nodiscard]] bool shows(std::string_view overlay) const { return reachOf(overlay) != PhysicsReach::Off; }
    void toggleOverlay(std::string_view overlay);
    /// The entities that an overlay is shown of.
    [[nodiscard]] PhysicsReach reachOf(std::string_view overlay) const;
    void setReach(std::string_view overlay, PhysicsReach whose);
    ReachView reach;            ///< of the overlay "reach"
    Trajectories trajectories;  ///< of the overlay "trajectories"

    ViewFile viewFile{project.root};  ///< what is hidden and locked, between two sessions
    SafetyNet safety{*this};          ///< of what is not saved

private:
    [[nodiscard]] SceneContext context() const;
    Result<LoadReport> load(const std::string& path, const std::string* text);
    Result<Done> write();

    PrefabLibrary* prefabs_;
    std::vector<std::unique_ptr<Tool>> tools_;
    std::size_t tool_ = 0;
};

}  // namespace plumb::editor
