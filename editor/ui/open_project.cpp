#include "editor/ui/open_project.hpp"

#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/templates/project_templates.hpp"
#include "platform/paths.hpp"

namespace plumb::editor::ui {

OpenProject::OpenProject(std::unique_ptr<ProjectSession> session, LogBook& log, RenderDevice* device)
    : log_{log}, device_{device} {
    use(std::move(session));
}

void OpenProject::use(std::unique_ptr<ProjectSession> session) {
    session_ = std::move(session);
    const TextureFilter filter = workspace().project.smooth ? TextureFilter::Linear : TextureFilter::Nearest;
    if (device_ != nullptr) picture_ = std::make_unique<SceneTexture>(*device_, session_->assets(), filter);
    window_ = std::make_unique<EditorWindow>(workspace(), log_, picture_.get(), engineAssets() / "fonts",
                                             workspace().settings.scale);
    if (device_ != nullptr) renderer_ = std::make_unique<ImguiRenderer>();
}

void OpenProject::closeProject() {
    renderer_.reset();
    window_.reset();
    picture_.reset();
    session_.reset();
}

std::string OpenProject::title() {
    return format("{}{} - Plumb", workspace().unsaved() ? "* " : "", workspace().project.name);
}

Result<Done> OpenProject::change(const std::string& folder, const std::function<void()>& leaving) {
    // Clears the log: its lines and their links refer to the files and entities of the old project.
    if (isProject(folder)) log_.clear();
    Result<Project> next = loadProject(folder);
    if (!next) {
        workspace().notice = next.error().text();
        logError("Project", next.error());
        return next.error();
    }
    workspace().stopPlaying();
    if (leaving) leaving();
    Settings settings = workspace().settings;
    closeProject();  // first, as components of both projects may have equal names: those share descriptions
    std::unique_ptr<ProjectSession> session = ProjectSession::open(*std::move(next));
    session->workspace().settings = std::move(settings);
    session->openFirst({});
    use(std::move(session));
    workspace().safety.begin();
    remember();
    return Done{};
}

void OpenProject::remember() {
    if (workspace().project.isNone) return;
    std::error_code failed;
    const Path folder = std::filesystem::absolute(workspace().project.root, failed).lexically_normal();
    workspace().settings.remember((folder.has_filename() ? folder : folder.parent_path()).string());
}

}  // namespace plumb::editor::ui
