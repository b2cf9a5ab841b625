#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "editor/model/assets/hot_reload.hpp"
#include "editor/ui/dialogs/finder_dialog.hpp"
#include "editor/ui/dialogs/import_dialog.hpp"
#include "editor/ui/dialogs/keep_dialog.hpp"
#include "editor/ui/dialogs/prefab_dialogs.hpp"
#include "editor/ui/dialogs/preferences_dialog.hpp"
#include "editor/ui/dialogs/safety_dialogs.hpp"
#include "editor/ui/layout_menu.hpp"
#include "editor/ui/panes.hpp"
#include "editor/ui/platform_feed.hpp"
#include "editor/ui/ui.hpp"
#include "editor/ui/welcome_screen.hpp"
#include "input/device_state.hpp"

struct ImGuiContext;

namespace plumb::editor::ui {

/// The whole editor for one frame after another. Fed with plain events, so that tests and people use the same
/// door; drawing what it made is the business of the owner of the graphics device.
class EditorWindow {
public:
    /// @param log      what the console shows
    /// @param fonts    the folder of the engine's fonts
    /// @param picture  null: headless, the viewport stays empty
    EditorWindow(Workspace& workspace, LogBook& log, ScenePicture* picture, Path fonts, float scale = 1.0f);
    ~EditorWindow();
    EditorWindow(const EditorWindow&) = delete;
    EditorWindow& operator=(const EditorWindow&) = delete;

    /// Builds one frame; ImGui::GetDrawData() holds it afterwards.
    void frame(const FrameInput& input);

    [[nodiscard]] const WidgetMap& widgets() const { return widgets_; }
    [[nodiscard]] bool wantsQuit() const { return quit_; }
    /// The folder of another project that the person chose, once; empty: none.
    std::string takeProject() { return std::exchange(project_, {}); }
    /// For a folder in which there is no project yet.
    void welcome(const std::string& folder) { welcome_.open(ui_, folder); }
    [[nodiscard]] MouseShape mouseShape() const;
    /// True once after the fonts changed: their texture must be made again.
    bool takeFontsChanged() { return std::exchange(fontsChanged_, false); }
    [[nodiscard]] bool pending() const { return feed_->pending(); }

private:
    void handleKeys(std::span<const Event> events);
    /// Those of the welcome screen: the scene behind it shall not hear them.
    void handleWelcomeKeys(std::span<const Event> events);
    void drawAll();
    [[nodiscard]] bool isForGame(const Event& event, bool typing) const;
    /// What the hands do; the mouse where it is in the game's own picture.
    InputFrame takeGameInput();
    void playGame(float seconds);
    void drawMenus();
    void drawOverlayMenu();
    void drawMenu(const char* menu);
    void drawTitle();
    /// The panel of a file that is to be edited comes to the front.
    void showAssetPanel();
    void drawStatus(float height);
    [[nodiscard]] std::string stateInWords(float width) const;
    [[nodiscard]] std::string noticeInWords() const;
    void drawDialogs();
    void drawNewScene();
    /// Opens a scene or makes a new one, after the person said what to do with unsaved changes.
    void leaveFor(std::function<void()> next);
    void drawUnsaved();
    void openScene(const std::string& path);
    /// Whether theme or size are no longer those that are shown.
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
    ImportDialog import_;
    FinderDialog finder_;
    PreferencesDialog preferences_;
    WelcomeScreen welcome_;
    std::string project_;  ///< to be opened instead of this one
    HotReload hotReload_{workspace_};
    std::function<void()> next_;  ///< what comes once the person said what to do with unsaved changes
    std::array<char, 64> newScene_{};
    std::string newSceneError_;
    std::string unsavedProblem_;  ///< why the scene could not be saved before it is left
    Theme theme_ = Theme::Dark;   ///< as it is shown, like the text size
    float textSize_ = 0.0f;
    bool askUnsaved_ = false;
    bool quit_ = false;
    bool fontsChanged_ = true;
};

}  // namespace plumb::editor::ui
