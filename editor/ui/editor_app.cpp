#include "editor/ui/editor_app.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "assets/asset_store.hpp"
#include "core/clock.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/project/project_session.hpp"
#include "editor/model/view/thumbnail.hpp"
#include "editor/templates/new_project.hpp"
#include "editor/templates/project_templates.hpp"
#include "editor/ui/open_project.hpp"
#include "editor/ui/tour.hpp"
#include "platform/image_file.hpp"
#include "platform/paths.hpp"
#include "platform/process_time.hpp"
#include "platform/window.hpp"
#include "render/gl/gl_device.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kExample = "projects/platformer";
constexpr int kPictureWidth = 256;  // px: size of a project's preview image
constexpr int kPictureHeight = 144;
constexpr int kScreenshotFrames = 4;  // frames until the layout of panes and fonts is stable

int fail(const Error& error) {
    std::fprintf(stderr, "plumb-editor: %s\n", error.text().c_str());
    return 1;
}

/// The running editor: the window, the graphics device, and the open project.
class App {
public:
    /// @param settingsFile  null: changed settings are not saved
    App(std::unique_ptr<ProjectSession> session, LogBook& log, SettingsFile* settingsFile,
        std::unique_ptr<Window> window, std::unique_ptr<GlDevice> device)
        : settingsFile_{settingsFile},
          window_{std::move(window)},
          device_{std::move(device)},
          open_{std::move(session), log, device_.get()} {}
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    [[nodiscard]] EditorWindow& editor() { return open_.window(); }

    void run() {
        open_.remember();
        double before = wallSeconds();
        while (!editor().wantsQuit()) {
            std::vector<Event> events;
            const bool busy = workspace().play.running() || editor().pending() || --idleFrames_ > 0;
            if (busy) {
                window_->pollEvents(events);
            } else {
                window_->waitEvents(events, HotReload::kInterval);
            }
            if (!events.empty()) idleFrames_ = kIdleFrames;
            const double now = wallSeconds();
            frame(events, static_cast<float>(now - before));
            if (settingsFile_ != nullptr) settingsFile_->update(workspace().settings, now - before);
            before = now;
            window_->swap();
            tellReady();
            openChosen();
        }
        keepPicture();
        if (settingsFile_ != nullptr) static_cast<void>(settingsFile_->save(workspace().settings).ok());
    }

    Result<Done> screenshot(const std::string& path) {
        for (int i = 0; i < kScreenshotFrames; ++i) {
            frame({}, 1.0f / 60.0f);
            tellReady();
        }
        return writePicture(path);
    }

    /// Runs a tour script. @param path  the script; its screenshots are written relative to its folder
    Result<Done> playTour(const Path& path) {
        const Result<std::string> text = readFile(path);
        if (!text) return text.error();
        const Result<Tour> tour = Tour::read(*text, path.filename().string());
        if (!tour) return tour.error();
        return tour->play({[this]() -> const EditorWindow& { return editor(); },
                           [this]() -> const Workspace& { return workspace(); },
                           [this](const std::vector<Event>& events) {
                               frame(events, 1.0f / 60.0f);
                               openChosen();
                           },
                           [&](std::string_view name) { return writePicture(path.parent_path() / name); }});
    }

private:
    static constexpr int kIdleFrames = 30;

    [[nodiscard]] Workspace& workspace() { return open_.workspace(); }

    /// Logs the startup time once, after the first frame, when the editor accepts input.
    void tellReady() {
        if (std::exchange(ready_, true)) return;
        logNote("Editor", "Ready after {} s", fixedText(processSeconds(), 2));
    }

    void openChosen() {
        if (const std::string project = editor().takeProject(); !project.empty()) change(project);
    }

    void change(const std::string& project) {
        static_cast<void>(open_.change(project, [this] { keepPicture(); }).ok());
        idleFrames_ = kIdleFrames;
    }

    /// Saves an image of the scene view as the preview of the project in the list of recent ones.
    void keepPicture() {
        if (workspace().project.isNone || workspace().document.scenePath.empty()) return;
        editor().showScene();
        frame({}, 1.0f / 60.0f);  // draws again, as a framebuffer is undefined after its swap
        const WidgetMap::Widget* scene = editor().widgets().find("Viewport");
        if (scene == nullptr) return;
        const AABB box = scene->box;
        const float pixels = static_cast<float>(window_->drawableSize().width) /
                             static_cast<float>(std::max(window_->size().width, 1));
        const Image small = thumbnailOf(device_->readPixels({}), {box.min * pixels, box.max * pixels},
                                        kPictureWidth, kPictureHeight);
        if (const Result<std::string> png = encodePng(small); png) {
            static_cast<void>(writeFile(projectPicture(workspace().project.root), *png).ok());
        }
    }

    Result<Done> writePicture(const Path& path) {
        const Result<std::string> png = encodePng(device_->readPixels({}));
        if (!png) return png.error();
        return writeFile(path, *png);
    }

    void frame(const std::vector<Event>& events, float seconds) {
        if (editor().takeFontsChanged()) open_.renderer().uploadFonts();
        Workspace& open = workspace();
        const std::string copied = open.clipboard = window_->clipboardText();
        editor().frame({events, window_->size(), window_->drawableSize(), seconds});
        if (open.clipboard != copied) window_->setClipboardText(open.clipboard);
        window_->setMouseShape(editor().mouseShape());
        if (std::string title = open_.title(); title != title_) window_->setTitle(title_ = std::move(title));

        const PixelSize size = window_->drawableSize();
        device_->setWindowSize(size);
        device_->setViewport({{}, 0, 0, size.width, size.height});
        device_->clear({20, 21, 25, 255});
        open_.renderer().draw();
    }

    SettingsFile* settingsFile_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<GlDevice> device_;
    OpenProject open_;  // uses window_ and device_, so it must be destroyed first
    std::string title_;
    int idleFrames_ = kIdleFrames;
    bool ready_ = false;
};

void selectByName(Workspace& workspace, const std::string& name) {
    Document& document = workspace.document;
    for (const ObjectId id : document.objects()) {
        if (document.nameOf(id) == name) document.selection.add(id);
    }
    if (document.selection.empty()) workspace.notice = format("The scene has no entity \"{}\"", name);
}

/// Returns the user's settings, overridden by the command line.
/// @param file    null: the default settings are used
/// @param notice  receives the last problem found in the file
Settings loadSettings(SettingsFile* file, const EditorOptions& options, std::string& notice) {
    Settings settings;
    if (file != nullptr) {
        for (const Error& problem : file->load(settings)) {
            logWarning("Settings", problem);
            notice = problem.text();
        }
    }
    if (options.scale > 0.0f) settings.scale = options.scale;
    if (!options.theme.empty()) settings.theme = options.theme == "light" ? Theme::Light : Theme::Dark;
    return settings;
}

}  // namespace

int runEditor(const EditorOptions& given) {
    EditorOptions options = given;
    const bool namesScene = !options.scene.empty() || !options.select.empty();
    const bool withoutWindow = !options.importFrom.empty() || options.validate;
    if (options.project.empty() && (namesScene || withoutWindow)) options.project = kExample;
    if (!options.newProject.empty()) return newProject(options.from, options.newProject);
    if (!options.importFrom.empty()) return importFile(options);
    LogBook log;
    // Screenshots ignore the user's settings, so that they are reproducible, unless PLUMB_CONFIG is set.
    const bool takesPictures = !options.screenshot.empty() || !options.tour.empty();
    SettingsFile file;
    SettingsFile* kept = takesPictures && std::getenv("PLUMB_CONFIG") == nullptr ? nullptr : &file;
    std::string notice;
    Settings settings;
    if (!options.validate) settings = loadSettings(kept, options, notice);
    if (options.project.empty() && !settings.welcome && !settings.recent.empty() &&
        isProject(settings.recent.front()))
        options.project = settings.recent.front();

    std::error_code failed;
    const bool noProject = !options.project.empty() && !takesPictures && !options.validate &&
                           std::filesystem::is_directory(options.project, failed) &&
                           !isProject(options.project);
    const bool welcome = options.welcome || options.project.empty() || noProject;
    Result<std::unique_ptr<ProjectSession>> session =
        welcome ? Result<std::unique_ptr<ProjectSession>>{ProjectSession::none()}
                : ProjectSession::open(options.project);
    if (!session) return fail(session.error());
    if (options.validate) return (*session)->validate();
    if (!options.resources.empty()) return (*session)->writeResources(options.resources);
    if (!options.exportTo.empty()) return (*session)->exportGame(options);

    Workspace& workspace = (*session)->workspace();
    workspace.settings = settings;
    if (!welcome && !options.replay.empty()) {
        const Result<Done> played = (*session)->openReplay(options.replay, takesPictures);
        if (!played) return fail(played.error());
    } else if (!welcome) {
        (*session)->openFirst(options.scene);
    }
    if (takesPictures && !welcome && !options.scene.empty() && workspace.document.scenePath.empty())
        return fail({options.scene, "the project has no such scene",
                     "pass the name of one in " + (*session)->workspace().project.root.string() + "/scenes"});
    if (!notice.empty()) workspace.notice = notice;
    if (!options.select.empty()) selectByName(workspace, options.select);

    auto window = Window::open(
        {.title = "Plumb", .width = options.width, .height = options.height, .hidden = takesPictures});
    if (!window) return fail(window.error());
    (*window)->openPads();  // gamepads, for games run in the editor
    auto device = GlDevice::create();
    if (!device) return fail(device.error());
    App app{std::move(*session), log, kept, std::move(*window), std::move(*device)};
    if (noProject) app.editor().welcome(options.project);
    if (!takesPictures) {
        if (!welcome) workspace.safety.begin();
        app.run();
        return 0;
    }
    const Result<Done> written =
        options.tour.empty() ? app.screenshot(options.screenshot) : app.playTour(options.tour);
    return written ? 0 : fail(written.error());
}

}  // namespace plumb::editor::ui
