#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "editor/model/assets/hot_reload.hpp"
#include "editor/ui/dialogs/export_dialog.hpp"
#include "editor/ui/dialogs/finder_dialog.hpp"
#include "editor/ui/dialogs/import_dialog.hpp"
#include "editor/ui/dialogs/keep_dialog.hpp"
#include "editor/ui/dialogs/prefab_dialogs.hpp"
#include "editor/ui/dialogs/preferences_dialog.hpp"
#include "editor/ui/dialogs/safety_dialogs.hpp"
#include "editor/ui/dialogs/scene_name_dialog.hpp"
#include "editor/ui/layout_menu.hpp"
#include "editor/ui/panes.hpp"
#include "editor/ui/platform_feed.hpp"
#include "editor/ui/ui.hpp"
#include "editor/ui/welcome_screen.hpp"
#include "input/device_state.hpp"

struct ImGuiContext;

namespace plumb::editor::ui {

/// The contents of the editor's window. Each frame takes its input as Event values, so that tests use the
/// window in the same way as users. The caller, which owns the graphics device, draws ImGui's draw data.
class EditorWindow {
public:
    /// @param log      log shown in the console
    /// @param fonts    folder of the engine's fonts
    /// @param picture  renderer of the scene; null: headless, the viewport stays empty
    EditorWindow(Workspace& workspace, LogBook& log, SceneTexture* picture, Path fonts, float scale = 1.0f);
    ~EditorWindow();
    EditorWindow(const EditorWindow&) = delete;
    EditorWindow& operator=(const EditorWindow&) = delete;

    /// Builds one frame; afterwards ImGui::GetDrawData() returns its draw data.
    void frame(const FrameInput& input);

    [[nodiscard]] const WidgetMap& widgets() const { return widgets_; }
    [[nodiscard]] bool wantsQuit() const { return quit_; }
    /// Returns and clears the folder of the project that the user wants to open; empty if there is none.
    std::string takeProject() { return std::exchange(project_, {}); }
    /// Shows the welcome screen, to create a project in this folder.
    void welcome(const std::string& folder) { welcome_.open(ui_, folder); }
    /// Closes the welcome screen of an open project, so that the next frame shows the scene.
    void showScene() { welcome_.close(ui_); }
    [[nodiscard]] MouseShape mouseShape() const;
    /// Returns true once after the fonts have changed: the font texture must then be uploaded again.
    bool takeFontsChanged() { return std::exchange(fontsChanged_, false); }
    [[nodiscard]] bool pending() const { return feed_->pending(); }  ///< events are queued

private:
    void handleKeys(std::span<const Event> events);
    /// Handles the keys while the welcome screen is shown; the hidden scene receives no events then.
    void handleWelcomeKeys(std::span<const Event> events);
    void drawAll();
    [[nodiscard]] bool isForGame(const Event& event, bool typing) const;
    /// Returns the input for the game since the last call; mouse position in px of the game's image.
    InputFrame takeGameInput();
    void playGame(float seconds);
    void drawMenus();
    void drawOverlayMenu();
    void drawMenu(const char* menu);
    void drawTitle();
    /// Brings the panel Workspace::panelToShow, or the panel for assetToShow or assetToEdit, to the front.
    void showAssetPanel();
    void drawStatus(float height);
    /// Return the right and the left text of the status bar. @param width  px, room for the right one
    [[nodiscard]] std::string stateInWords(float width) const;
    [[nodiscard]] std::string noticeInWords() const;
    void drawDialogs();
    void drawSceneName();
    /// Calls `next`, which closes the open scene. If it has unsaved changes, first asks the user about them.
    void leaveFor(std::function<void()> next);
    void drawUnsaved();
    void openScene(const std::string& path);
    /// True if the theme, the scale or the text size in the settings has changed since the last applyLook().
    [[nodiscard]] bool looksOld() const;
    void applyLook();

    Workspace& workspace_;
    ImGuiContext* context_ = nullptr;
    Path fontFolder_;
    WidgetMap widgets_;
    std::unique_ptr<PlatformFeed> feed_;
    Ui ui_;
    Panes panes_;
    LayoutMenu layoutMenu_;
    DeviceState devices_;
    KeepDialog keep_;
    PrefabDialogs prefabDialogs_;
    SafetyDialogs safety_;
    SceneNameDialog sceneName_;
    ImportDialog import_;
    ExportDialog export_;
    FinderDialog finder_;
    PreferencesDialog preferences_;
    WelcomeScreen welcome_;
    std::string project_;  ///< folder of the project to open; empty: none
    HotReload hotReload_{workspace_};
    std::function<void()> next_;  ///< called after the user decided about unsaved changes
    std::string unsavedProblem_;  ///< error of saving in the dialog about unsaved changes
    Theme theme_ = Theme::Dark;   ///< applied theme
    float textSize_ = 0.0f;       ///< applied text size, px at scale 1
    bool askUnsaved_ = false;
    bool quit_ = false;
    bool fontsChanged_ = true;
};

}  // namespace plumb::editor::ui
