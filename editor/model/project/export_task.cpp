#include "editor/model/project/export_task.hpp"

#include <array>
#include <chrono>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

constexpr std::array kTargets{
    ExportTarget{"", "This computer",
                 "For computers with the libraries that are installed here. Quick, to try the game."},
    ExportTarget{"linux", "Linux",
                 "For every 64-bit desktop since 2018, without packages to install. With an archive."},
    ExportTarget{"windows", "Windows", "For Windows 10 or later, 64 bit. With an archive."},
    ExportTarget{"web", "Web browsers",
                 "A page for any static web host. With an archive, as hosts of games take it."},
    ExportTarget{"all", "Linux, Windows and web browsers", "All three, in folders of their own."},
};
constexpr int kDeepest = 6;  // folders from the sources to the editor: build/release/bin

}  // namespace

std::span<const ExportTarget> exportTargets() { return kTargets; }

Path plumbScript(const Path& editor) {
    std::error_code failed;
    Path folder = std::filesystem::weakly_canonical(editor, failed).parent_path();
    for (int i = 0; i < kDeepest && !failed && folder.has_relative_path();
         ++i, folder = folder.parent_path()) {
        if (fileExists(folder / "player/targets/export.sh") && fileExists(folder / "plumb"))
            return folder / "plumb";
    }
    return {};
}

std::string exportFolder(const Path& project, const ExportTarget& target) {
    std::error_code failed;
    const Path whole = std::filesystem::absolute(project, failed).lexically_normal();
    const Path root = whole.has_filename() ? whole : whole.parent_path();
    const char* ending = *target.name != '\0' ? target.name : "export";
    return (root.parent_path() / format("{}-{}", root.filename().string(), ending)).generic_string();
}

void ExportTask::start(const Path& editor, const Path& project, const ExportTarget& target,
                       const std::string& folder) {
    std::vector<std::string> words{editor.string(), project.string(), "--export", folder};
    if (*target.name != '\0')
        words = {plumbScript(editor).string(), "export", project.string(), folder, "--to", target.name};
    {
        const std::lock_guard lock{mutex_};
        text_.clear();
    }
    const auto hear = [this](std::string_view text) {
        const std::lock_guard lock{mutex_};
        text_ += text;
    };
    stop_ = {};
    end_ = std::async(std::launch::async,
                      [words, hear, token = stop_.get_token()] { return runProgram(words, hear, token); });
}

std::string ExportTask::text() const {
    const std::lock_guard lock{mutex_};
    return text_;
}

std::optional<ProgramEnd> ExportTask::poll() {
    if (!running() || end_.wait_for(std::chrono::seconds{0}) != std::future_status::ready) return {};
    return end_.get();
}

}  // namespace plumb::editor
