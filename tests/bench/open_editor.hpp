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

/// A project in a folder of its own among the temporary ones; gone with this.
class TemporaryProject {
public:
    /// @param name  of the folder, so that two benchmarks can run at a time
    explicit TemporaryProject(std::string_view name);
    ~TemporaryProject();
    TemporaryProject(const TemporaryProject&) = delete;
    TemporaryProject& operator=(const TemporaryProject&) = delete;

    [[nodiscard]] const Path& root() const { return root_; }
    void write(std::string_view path, std::string_view text) const;

private:
    Path root_;
};

/// The whole editor with one scene open, as the program makes it: its panels, fonts and pictures, and the
/// journal. Only the graphics card is left out: a device takes all that is drawn and forgets it.
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
    /// The middle of what the scene is shown in (px of the window).
    [[nodiscard]] Vec2 middle() const;

private:
    editor::LogBook log_;
    RecordingDevice device_;
    std::unique_ptr<editor::ProjectSession> session_;
    std::unique_ptr<editor::ui::ScenePicture> picture_;
    std::unique_ptr<editor::ui::EditorWindow> window_;
    Vec2 place_;
};

/// What one did again and again, in seconds, for a line of the editor's tables.
struct Times {
    double median = 0.0;
    double worst = 0.0;
};

/// The rows of the editor's tables: milliseconds beside what they may be.
class TimeTable {
public:
    /// @param what  stands above the names
    explicit TimeTable(std::string_view what);
    /// @param target  s, 0: none. The worst is held against it where it was measured, else the median
    void add(const std::string& name, std::size_t n, Times times, double target);
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

private:
    std::vector<Row> rows_;
};

/// Runs it some times. The maximum is not reported: it would include other work of the machine.
/// @param clock  threadSeconds for what the target calls time of the processor, else wallSeconds
Times timesOf(int rounds, double (*clock)(), const std::function<void(int)>& run);

double medianOf(std::vector<double> seconds);

/// Runs passes of frames at the pace of a display, so that work beside them, such
/// as the journal, gets as much time as it has while a user edits. The reported
/// maximum is what recurs in every pass: the longest frame of the best pass.
Times pacedTimesOf(int passes, int frames, const std::function<void(int)>& run);

/// How long one waits for the editor, for a game in it, and for files that other programs write: in
/// start_bench.cpp, a part of the benchmark of the editor.
std::vector<Row> runStarts(const Options& options);

}  // namespace plumb::bench
