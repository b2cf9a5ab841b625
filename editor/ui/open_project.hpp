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

/// The project that is open in the editor; it can be replaced by another project. Each project has its own
/// workspace and window contents; only the user's settings are passed on to the next project.
class OpenProject {
public:
    /// @param device  graphics device; null: headless, nothing is drawn
    OpenProject(std::unique_ptr<ProjectSession> session, LogBook& log, RenderDevice* device);
    ~OpenProject() { closeProject(); }
    OpenProject(const OpenProject&) = delete;
    OpenProject& operator=(const OpenProject&) = delete;

    [[nodiscard]] Workspace& workspace() { return session_->workspace(); }
    [[nodiscard]] EditorWindow& window() { return *window_; }
    /// @pre  the project was opened with a graphics device
    [[nodiscard]] ImguiRenderer& renderer() { return *renderer_; }
    /// Returns the title of the program's window.
    [[nodiscard]] std::string title();

    /// Replaces this project by another one. Stops a running game and discards unsaved changes, so the caller
    /// must ask the user about them first.
    /// @param leaving  called before this project is closed; may be null
    /// @error          the other project cannot be opened; this one stays open
    Result<Done> change(const std::string& folder, const std::function<void()>& leaving = nullptr);
    /// Puts the project first in the list of recent projects.
    void remember();

private:
    void use(std::unique_ptr<ProjectSession> session);  ///< creates the window of a project
    void closeProject();                                ///< closes the project and its window

    LogBook& log_;
    RenderDevice* device_;
    // The order matters: each member uses the members declared before it.
    std::unique_ptr<ProjectSession> session_;
    std::unique_ptr<SceneTexture> picture_;
    std::unique_ptr<EditorWindow> window_;
    std::unique_ptr<ImguiRenderer> renderer_;
};

}  // namespace plumb::editor::ui
