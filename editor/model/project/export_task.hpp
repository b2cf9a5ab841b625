#pragma once

#include <future>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "editor/model/project/program.hpp"

namespace plumb::editor {

/// What an exported game runs on.
struct ExportTarget {
    const char* name;   ///< of `plumb export --to`; empty: this computer
    const char* label;  ///< in the dialog
    const char* text;   ///< what players need, and what comes out
};

/// All targets; the first is this computer, which needs nothing but the editor.
std::span<const ExportTarget> exportTargets();

/// Returns the script `plumb` of the sources from which this editor was built, which builds the players of
/// other systems; empty: the editor was moved elsewhere, or this system does not run the script.
/// @param editor  the program plumb-editor
Path plumbScript(const Path& editor);

/// Returns the folder that is offered first, beside the project: "NAME-windows".
std::string exportFolder(const Path& project, const ExportTarget& target);

/// Exports a project in the background: a second editor without a window does it, or the script `plumb`, so
/// that the open scene and a running game stay untouched. Unsaved changes are not part of the export.
class ExportTask {
public:
    ExportTask() = default;
    ~ExportTask() { stop(); }
    ExportTask(const ExportTask&) = delete;
    ExportTask& operator=(const ExportTask&) = delete;

    /// @param editor  the program plumb-editor
    /// @param folder  destination; relative to the current folder of this program
    void start(const Path& editor, const Path& project, const ExportTarget& target,
               const std::string& folder);
    /// Ends a running export. What it wrote completely stays; poll() returns its end soon.
    void stop() { stop_.request_stop(); }
    [[nodiscard]] bool running() const { return end_.valid(); }
    /// Returns what the export has printed until now.
    [[nodiscard]] std::string text() const;
    /// Returns once what the finished export printed; must be called in every frame.
    std::optional<ProgramEnd> poll();

private:
    mutable std::mutex mutex_;
    std::string text_;  // guarded by mutex_
    std::stop_source stop_;
    std::future<ProgramEnd> end_;
};

}  // namespace plumb::editor
