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
#include "editor/ui/dialogs/safety_dialogs.hpp"
#include "editor/ui/platform_feed.hpp"
#include "editor/ui/ui.hpp"
#include "input/device_state.hpp"

struct ImGuiContext;

namespace plumb::editor::ui {

/// The whole editor for one frame after another. Fed with plain events, so that tests and people use the same
/// door; drawing what it made is the business of whoever owns the graphics card.
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
    [[nodiscard]] MouseShape mouseShape() const;
    /// True once after the fonts changed: their texture must be made again.
    bool takeFontsChanged() { return std::exchange(fontsChanged_, false); }
    [[nodiscard]] bool pending() const { return feed_->pending(); }

private:
    /// Sizes of the panes as parts of the window, so that they survive any size.
    struct Layout {
        float left = 0.18f;
        float right = 0.24f;
        float bottom = 0.22f;
        float tiles = 0.38f;  ///< the bottom, while the tiles are shown in it
    };

    void handleKeys(std::span<const Event> events);
    [[nodiscard]] bool isForGame(const Event& event) const;
    /// What the hands do; the mouse where it is in the game's own picture.
    InputFrame takeGameInput();
    void playGame(float seconds);
    void drawMenus();
    void drawOverlayMenu();
    void drawToolbar(float height);
    void drawPhysicsButton();
    /// For each layer of the physics: of nobody, of the selected, of all. @param path  how tests call them
    void physicsLayerItems(const std::string& path);
    void toolButton(std::string_view action, bool on, ImU32 color);
    void drawPanes(ImVec2 from, ImVec2 size);
    /// The palette comes with the first tile tool, and goes with the last.
    void showTilesWhilePainting();
    /// The panel of a file that somebody wants to edit comes to the front.
    void showAssetPanel();
    void drawPane(Dock dock, ImVec2 from, ImVec2 size);
    void splitter(const char* id, ImVec2 from, ImVec2 size, bool vertical, float& part, float whole,
                  float sign);
    void drawStatus(float height);
    void drawDialogs();
    void drawSceneChooser();
    void drawPrefabChooser();
    void drawNewScene();
    /// Opens a scene or makes a new one, after the person said what to do with unsaved changes.
    void leaveFor(std::function<void()> next);
    void drawUnsaved();
    void openScene(const std::string& path);
    void setScale(float scale);

    Workspace& workspace_;
    ImGuiContext* context_ = nullptr;
    Path fontFolder_;
    WidgetMap widgets_;
    std::unique_ptr<PlatformFeed> feed_;
    Ui ui_;
    std::vector<std::unique_ptr<Panel>> panels_;
    Layout layout_;
    std::size_t bottomTab_ = 1;  ///< the console
    std::size_t tabBefore_ = 1;  ///< what the tiles took the place of
    bool paintedTiles_ = false;
    DeviceState devices_;
    KeepDialog keep_;
    PrefabDialogs prefabDialogs_;
    SafetyDialogs safety_;
    ImportDialog import_;
    FinderDialog finder_;
    HotReload hotReload_{workspace_};
    std::function<void()> next_;  ///< what comes once the person said what to do with unsaved changes
    std::array<char, 64> newScene_{};
    std::string newSceneError_;
    bool askUnsaved_ = false;
    bool quit_ = false;
    bool fontsChanged_ = true;
};

}  // namespace plumb::editor::ui
