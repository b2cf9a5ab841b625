#include "editor/model/project/export_task.hpp"

#include <chrono>

#include "core/text.hpp"

namespace plumb::editor {

std::string ExportTask::folderBeside(const Path& project) {
    std::error_code failed;
    const Path whole = std::filesystem::absolute(project, failed).lexically_normal();
    const Path root = whole.has_filename() ? whole : whole.parent_path();
    return (root.parent_path() / format("{}-export", root.filename().string())).generic_string();
}

void ExportTask::start(const Path& editor, const Path& project, const std::string& folder) {
    end_ = std::async(std::launch::async, runProgram,
                      std::vector{editor.string(), project.string(), std::string{"--export"}, folder});
}

std::optional<ProgramEnd> ExportTask::poll() {
    if (!running() || end_.wait_for(std::chrono::seconds{0}) != std::future_status::ready) return {};
    return end_.get();
}

}  // namespace plumb::editor
