#pragma once

#include <functional>
#include <memory>
#include <string>

#include "editor/model/project/project_session.hpp"
#include "editor/ui/editor_window.hpp"
#include "editor/ui/imgui_renderer.hpp"
#include "editor/ui/scene_picture.hpp"

namespace plumb {
class RenderDevice;
}

namespace plumb::editor::ui {

/// One project after another in the editor, each with a workspace and a window's contents of its own: nothing
/// of one is seen in the next but what the person likes.
class OpenProject {
public:
    /// @param device  null: headless, nothing is drawn
    OpenProject(std::unique_ptr<ProjectSession> session, LogBook& log, RenderDevice* device);
    ~OpenProject() { letGo(); }
    OpenProject(const OpenProject&) = delete;
    OpenProject& operator=(const OpenProject&) = delete;

    [[nodiscard]] Workspace& workspace() { return session_->workspace(); }
    [[nodiscard]] EditorWindow& window() { return *window_; }
    /// @pre  there is a device
    [[nodiscard]] ImguiRenderer& renderer() { return *renderer_; }
    /// What the title of the program's window says.
    [[nodiscard]] std::string title();

    /// Another project takes the place of this one. Unsaved changes were asked for before; a game that plays
    /// ends.
    /// @param leaving  called while this one is still there
    /// @error          it cannot be opened; this one stays
    Result<Done> change(const std::string& folder, const std::function<void()>& leaving = nullptr);
    /// Puts it first among the recent projects.
    void remember();

private:
    void use(std::unique_ptr<ProjectSession> session);
    void letGo();

    LogBook& log_;
    RenderDevice* device_;
    // In the order in which they need each other.
    std::unique_ptr<ProjectSession> session_;
    std::unique_ptr<ScenePicture> picture_;
    std::unique_ptr<EditorWindow> window_;
    std::unique_ptr<ImguiRenderer> renderer_;
};

}  // namespace plumb::editor::ui
