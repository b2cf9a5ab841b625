#include "editor/model/safety/backups.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/safety/file_times.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".backup";

/// Returns the backup files sorted by name. The names are numbers, so the oldest file comes first.
std::vector<Path> filesIn(const Path& folder) {
    std::vector<Path> files;
    std::error_code failed;
    for (fs::directory_iterator at{folder, failed}, end; !failed && at != end; at.increment(failed)) {
        if (endsWith(at->path().filename().string(), kEnding)) files.push_back(at->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void dropOldest(const Path& folder) {
    const std::vector<Path> files = filesIn(folder);
    std::error_code failed;
    for (std::size_t i = 0; i + Backups::kCopies < files.size(); ++i) fs::remove(files[i], failed);
}

}  // namespace

Path makeEditorFolder(const Path& project) {
    const Path folder = project / ".plumb";
    std::error_code failed;
    if (!fs::exists(folder / ".gitignore", failed))
        static_cast<void>(writeFile(folder / ".gitignore", "*\n").ok());
    return folder;
}

Path Backups::folderOf(std::string_view file) const { return project_ / ".plumb" / "backups" / Path{file}; }

Path Backups::nextPath(const Path& folder) const {
    makeEditorFolder(project_);
    std::error_code failed;
    fs::create_directories(folder, failed);
    const std::vector<Path> files = filesIn(folder);
    const auto last = files.empty() ? std::nullopt : parseInt(files.back().stem().string());
    std::string number = format("{}", last.value_or(0) + 1);
    number.insert(0, number.size() < 8 ? 8 - number.size() : 0, '0');
    return folder / (number + std::string{kEnding});
}

void Backups::keep(std::string_view file) const {
    const Result<Path> path = pathInside(project_, file);
    std::error_code failed;
    if (!path || !fs::is_regular_file(*path, failed)) return;
    const Path folder = folderOf(file);
    const Path copy = nextPath(folder);
    // A hard link needs no copying. The file is saved by replacing it, so the link keeps the old content.
    fs::create_hard_link(*path, copy, failed);
    if (failed) fs::copy_file(*path, copy, failed);
    dropOldest(folder);
}

void Backups::keepText(std::string_view file, std::string_view text) const {
    const Path folder = folderOf(file);
    static_cast<void>(writeFile(nextPath(folder), text).ok());
    dropOldest(folder);
}

std::vector<Backup> Backups::of(std::string_view file) const {
    std::vector<Backup> found;
    std::error_code failed;
    for (const Path& path : filesIn(folderOf(file))) {
        found.push_back({path, whenWritten(path), fs::file_size(path, failed)});
    }
    std::reverse(found.begin(), found.end());
    return found;
}

}  // namespace plumb::editor
