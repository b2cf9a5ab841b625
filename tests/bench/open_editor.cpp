#include "tests/bench/open_editor.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "core/clock.hpp"
#include "core/text.hpp"
#include "platform/paths.hpp"

namespace plumb::bench {
namespace {

constexpr double kFrame = 1.0 / 60.0;  // s

constexpr std::string_view kProject = R"({
  "name": "Bench",
  "version": "0.1.0",
  "window": {"width": 1280, "height": 720},
  "resolution": [640, 360]
}
)";

std::string milliseconds(double seconds) {
    return seconds == 0.0 ? std::string{"-"} : fixedText(seconds * 1e3, 3);
}

}  // namespace

TemporaryProject::TemporaryProject(std::string_view name)
    : root_{std::filesystem::temp_directory_path() / format("plumb_{}", name)} {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_ / "scenes");
    write("project.json", kProject);
}

TemporaryProject::~TemporaryProject() {
    std::error_code none;
    std::filesystem::remove_all(root_, none);
}

void TemporaryProject::write(std::string_view path, std::string_view text) const {
    if (const Result<Done> written = writeFile(root_ / path, text); !written)
        std::fprintf(stderr, "%s\n", written.error().text().c_str());
}

OpenEditor::OpenEditor(const Path& project, std::string_view scene) {
    device_.recordsDraws = false;
    auto opened = editor::ProjectSession::open(project.string());
    if (!opened) {
        std::fprintf(stderr, "%s\n", opened.error().text().c_str());
        std::exit(1);
    }
    session_ = std::move(*opened);
    session_->openFirst(scene);
    workspace().safety.begin();
    picture_ =
        std::make_unique<editor::ui::SceneTexture>(device_, session_->assets(), TextureFilter::Nearest);
    window_ = std::make_unique<editor::ui::EditorWindow>(workspace(), log_, picture_.get(),
                                                         engineAssets() / "fonts");
    frames(4);
}

OpenEditor::~OpenEditor() = default;

void OpenEditor::frame(const std::vector<Event>& events) { window_->frame({events}); }

void OpenEditor::frames(int count) {
    for (int i = 0; i < count; ++i) frame();
}

void OpenEditor::key(Key key, Modifiers modifiers) {
    frame({{.kind = EventKind::KeyDown, .key = key, .modifiers = modifiers}});
    frame({{.kind = EventKind::KeyUp, .key = key}});
}

void OpenEditor::click(std::string_view widget) {
    const auto* found = window_->widgets().find(widget);
    if (found == nullptr) {
        std::fprintf(stderr, "widget %s was not found\n", std::string{widget}.c_str());
        std::exit(1);
    }
    moveTo(found->box.center());
    frame();
    press();
    release();
    frame();
}

void OpenEditor::type(std::string_view text) {
    for (const char letter : text) frame({{.kind = EventKind::TextInput, .text = std::string(1, letter)}});
}

Vec2 OpenEditor::middle() const {
    const auto* view = window_->widgets().find("Viewport");
    return view == nullptr ? Vec2{640.0f, 360.0f} : view->box.center();
}

TimeTable::TimeTable(std::string_view what) {
    std::printf("%-60s %9s %10s %10s %10s\n", std::string{what}.c_str(), "n", "median ms", "worst ms",
                "target ms");
}

void TimeTable::add(const std::string& name, std::size_t n, Times times, double target) {
    constexpr double kNanoseconds = 1e9;
    const double judged = times.worst > 0.0 ? times.worst : times.median;
    rows_.push_back(
        {name, n, judged * kNanoseconds, times.median * kNanoseconds, 0.0, target * kNanoseconds});
    std::printf("%-60s %9zu %10s %10s %10s  %s\n", name.c_str(), n, milliseconds(times.median).c_str(),
                milliseconds(times.worst).c_str(), milliseconds(target).c_str(),
                target == 0.0        ? ""
                : rows_.back().met() ? "met"
                                     : "MISSED");
    std::fflush(stdout);
}

Times timesOf(int rounds, double (*clock)(), const std::function<void(int)>& run) {
    std::vector<double> seconds;
    for (int i = 0; i < rounds; ++i) {
        const double start = clock();
        run(i);
        seconds.push_back(clock() - start);
    }
    return {medianOf(std::move(seconds)), 0.0};
}

double medianOf(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    return seconds.empty() ? 0.0 : seconds[seconds.size() / 2];
}

Times pacedTimesOf(int passes, int frames, const std::function<void(int)>& run) {
    Times best;
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<double> seconds;
        for (int i = 0; i < frames; ++i) {
            const double start = wallSeconds();
            run(i);
            seconds.push_back(wallSeconds() - start);
            const double rest = kFrame - seconds.back();
            if (rest > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(rest));
        }
        std::sort(seconds.begin(), seconds.end());
        if (pass == 0 || seconds.back() < best.worst) best = {seconds[seconds.size() / 2], seconds.back()};
    }
    return best;
}

}  // namespace plumb::bench
