#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "editor/model/project/project_session.hpp"
#include "editor/model/view/log_book.hpp"
#include "editor/ui/editor_window.hpp"
#include "editor/ui/scene_picture.hpp"
#include "render/recording_device.hpp"
#include "tests/bench/bench.hpp"

namespace plumb::bench {

/// A project in a temporary folder, which the destructor removes.
class TemporaryProject {
public:
    /// @param name  name of the folder, distinct for each benchmark so that several can run at the same time
    explicit TemporaryProject(std::string_view name);
    ~TemporaryProject();
    TemporaryProject(const TemporaryProject&) = delete;
    TemporaryProject& operator=(const TemporaryProject&) = delete;

    [[nodiscard]] const Path& root() const { return root_; }
    void write(std::string_view path, std::string_view text) const;

private:
    Path root_;
};

/// The complete editor with one open scene: panels, fonts, images and journal. Instead of a graphics card it
/// uses a device that discards all draw calls.
class OpenEditor {
public:
    OpenEditor(const Path& project, std::string_view scene);
    ~OpenEditor();
    OpenEditor(const OpenEditor&) = delete;
    OpenEditor& operator=(const OpenEditor&) = delete;

    [[nodiscard]] editor::Workspace& workspace() { return session_->workspace(); }
    [[nodiscard]] AssetStore& assets() { return session_->assets(); }
    [[nodiscard]] const RenderCounts& drawn() const { return picture_->counts; }

    void frame(const std::vector<Event>& events = {});
    void frames(int count);
    void key(Key key, Modifiers modifiers = {});
    void moveTo(Vec2 at) { frame({{.kind = EventKind::MouseMoved, .position = place_ = at}}); }
    void press() { frame({{.kind = EventKind::MouseDown, .position = place_}}); }
    void release() { frame({{.kind = EventKind::MouseUp, .position = place_}}); }
    void click(std::string_view widget);
    void type(std::string_view text);
    /// Returns the center of the scene's viewport, px in the window.
    [[nodiscard]] Vec2 middle() const;

private:
    editor::LogBook log_;
    RecordingDevice device_;
    std::unique_ptr<editor::ProjectSession> session_;
    std::unique_ptr<editor::ui::SceneTexture> picture_;
    std::unique_ptr<editor::ui::EditorWindow> window_;
    Vec2 place_;
};

/// Time of a repeated operation, s.
struct Times {
    double median = 0.0;
    double worst = 0.0;  ///< maximum; 0: not measured
};

/// Prints and collects the rows of a table: times and their targets, ms.
class TimeTable {
public:
    /// @param what  title of the first column, with the names of the rows
    explicit TimeTable(std::string_view what);
    /// @param target  s; 0: no target. Compared with the maximum if it was measured, else with the median
    void add(const std::string& name, std::size_t n, Times times, double target);
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

private:
    std::vector<Row> rows_;
};

/// Runs a function several times. The maximum is not reported, because it would include other work of the
/// machine.
/// @param clock  threadSeconds if the target is CPU time, else wallSeconds
Times timesOf(int rounds, double (*clock)(), const std::function<void(int)>& run);

double medianOf(std::vector<double> seconds);

/// Runs passes of frames at 60 Hz, so that parallel work such as the journal gets
/// as much time as when a user edits. The reported maximum is the longest frame
/// of the best pass, without delays that do not recur in every pass.
Times pacedTimesOf(int passes, int frames, const std::function<void(int)>& run);

/// Measures the time to start the editor, to start a game in it, and to reload files changed by other
/// programs. Part of the benchmark of the editor, in start_bench.cpp.
std::vector<Row> runStarts(const Options& options);

}  // namespace plumb::bench
