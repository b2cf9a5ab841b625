#include "editor/ui/editor_app.hpp"

#include <cstdio>
#include <memory>
#include <vector>

#include "assets/asset_store.hpp"
#include "core/clock.hpp"
#include "core/text.hpp"
#include "editor/model/project_session.hpp"
#include "editor/ui/editor_window.hpp"
#include "editor/ui/imgui_renderer.hpp"
#include "editor/ui/scene_picture.hpp"
#include "editor/ui/tour.hpp"
#include "platform/image_file.hpp"
#include "platform/paths.hpp"
#include "platform/window.hpp"
#include "render/gl/gl_device.hpp"

namespace plumb::editor::ui {
namespace {

constexpr int kScreenshotFrames = 4;  // panes and fonts have settled by then

int fail(const Error& error) {
    std::fprintf(stderr, "plumb-editor: %s\n", error.text().c_str());
    return 1;
}

/// The window, the graphics card and the editor in them.
class App {
public:
    App(ProjectSession& session, LogBook& log, std::unique_ptr<Window> window,
        std::unique_ptr<GlDevice> device, float scale)
        : session_{session},
          window_{std::move(window)},
          device_{std::move(device)},
          picture_{*device_, session.assets(),
                   session.workspace().project.smooth ? TextureFilter::Linear : TextureFilter::Nearest},
          editor_{session.workspace(), log, &picture_, engineAssets() / "fonts", scale} {}

    void run() {
        double before = wallSeconds();
        while (!editor_.wantsQuit()) {
            std::vector<Event> events;
            const bool busy = session_.workspace().play.running() || editor_.pending() || --idleFrames_ > 0;
            if (busy) {
                window_->pollEvents(events);
            } else {
                window_->waitEvents(events, HotReload::kInterval);
            }
            if (!events.empty()) idleFrames_ = kIdleFrames;
            const double now = wallSeconds();
            frame(events, static_cast<float>(now - before));
            before = now;
            window_->swap();
        }
    }

    Result<Done> screenshot(const std::string& path) {
        for (int i = 0; i < kScreenshotFrames; ++i) {
            frame({}, 1.0f / 60.0f);
        }
        return writePicture(path);
    }

    /// @param path  of the tour; its pictures are named from there
    Result<Done> playTour(const Path& path) {
        const Result<std::string> text = readFile(path);
        if (!text) return text.error();
        const Result<Tour> tour = Tour::read(*text, path.filename().string());
        if (!tour) return tour.error();
        return tour->play(editor_, session_.workspace(),
                          {[this](const std::vector<Event>& events) { frame(events, 1.0f / 60.0f); },
                           [&](std::string_view name) { return writePicture(path.parent_path() / name); }});
    }

private:
    static constexpr int kIdleFrames = 30;

    Result<Done> writePicture(const Path& path) {
        const Result<std::string> png = encodePng(device_->readPixels({}));
        if (!png) return png.error();
        return writeFile(path, *png);
    }

    void frame(const std::vector<Event>& events, float seconds) {
        if (editor_.takeFontsChanged()) renderer_.uploadFonts();
        Workspace& workspace = session_.workspace();
        const std::string copied = workspace.clipboard = window_->clipboardText();
        editor_.frame({events, window_->size(), window_->drawableSize(), seconds});
        if (workspace.clipboard != copied) window_->setClipboardText(workspace.clipboard);
        window_->setMouseShape(editor_.mouseShape());
        const std::string title =
            format("{}{} - Plumb", workspace.unsaved() ? "* " : "", workspace.project.name);
        if (title != title_) window_->setTitle(title_ = title);

        const PixelSize size = window_->drawableSize();
        device_->setWindowSize(size);
        device_->setViewport({{}, 0, 0, size.width, size.height});
        device_->clear({20, 21, 25, 255});
        renderer_.draw();
    }

    ProjectSession& session_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<GlDevice> device_;
    ScenePicture picture_;
    EditorWindow editor_;
    ImguiRenderer renderer_;
    std::string title_;
    int idleFrames_ = kIdleFrames;
};

void selectByName(Workspace& workspace, const std::string& name) {
    Document& document = workspace.document;
    for (const ObjectId id : document.objects()) {
        if (document.nameOf(id) == name) document.selection.add(id);
    }
    if (document.selection.empty()) workspace.notice = format("There is no entity \"{}\"", name);
}

}  // namespace

int runEditor(const EditorOptions& options) {
    if (!options.importFrom.empty()) return importFile(options);
    LogBook log;
    Result<std::unique_ptr<ProjectSession>> session = ProjectSession::open(options.project);
    if (!session) return fail(session.error());
    if (options.validate) return (*session)->validate();
    if (!options.exportTo.empty()) return (*session)->exportTo(options.exportTo);

    (*session)->openFirst(options.scene);
    Workspace& workspace = (*session)->workspace();
    if (!options.select.empty()) selectByName(workspace, options.select);

    auto window = Window::open({.title = "Plumb",
                                .width = options.width,
                                .height = options.height,
                                .hidden = !options.screenshot.empty() || !options.tour.empty()});
    if (!window) return fail(window.error());
    auto device = GlDevice::create();
    if (!device) return fail(device.error());
    App app{**session, log, std::move(*window), std::move(*device), options.scale};
    if (options.screenshot.empty() && options.tour.empty()) {
        workspace.safety.begin();
        app.run();
        return 0;
    }
    const Result<Done> written =
        options.tour.empty() ? app.screenshot(options.screenshot) : app.playTour(options.tour);
    return written ? 0 : fail(written.error());
}

}  // namespace plumb::editor::ui
