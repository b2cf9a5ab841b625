#pragma once

#include <future>
#include <optional>
#include <string>

#include "core/file.hpp"
#include "editor/model/project/program.hpp"

namespace plumb::editor {

/// Exports a project in the background: a second editor without a window does it, as `plumb export` does, so
/// that the open scene and a running game stay untouched. Unsaved changes are not part of the export.
class ExportTask {
public:
    /// Returns the folder that is offered first: "NAME-export" beside the project.
    static std::string folderBeside(const Path& project);

    /// @param editor  the program plumb-editor
    /// @param folder  destination; relative to the current folder of this program
    void start(const Path& editor, const Path& project, const std::string& folder);
    [[nodiscard]] bool running() const { return end_.valid(); }
    /// Returns once what the finished export printed; must be called in every frame.
    std::optional<ProgramEnd> poll();

private:
    std::future<ProgramEnd> end_;
};

}  // namespace plumb::editor
