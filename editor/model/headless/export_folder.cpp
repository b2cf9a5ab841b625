#include "editor/model/headless/export_folder.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/player.hpp"
#include "codec/pack.hpp"
#include "core/text.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStage = ".plumb-export";  // all that a killed export leaves
constexpr const char* kNew = "new";
constexpr const char* kOld = "old";
constexpr std::size_t kNamed = 3;  // files in a message

/// @param inner, outer  without links
bool isBelow(const Path& inner, const Path& outer) {
    const Path relative = inner.lexically_relative(outer);
    return !relative.empty() && *relative.begin() != "..";
}

/// The first names in a folder, sorted: "a.txt, b.txt, c.txt and 4 more".
std::string contentOf(const Path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, ignored}) {
        if (entry.path().filename() != kStage) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) text += (i == 0 ? "" : ", ") + names[i];
    return names.size() <= kNamed ? text : text + format(" and {} more", names.size() - kNamed);
}

/// The name of the game in a pack.
Result<std::string> gameIn(const Path& file) {
    const Result<std::shared_ptr<const Pack>> pack = Pack::open(file);
    if (!pack) return pack.error();
    const auto paths = (*pack)->paths();
    const auto at = std::find(paths.begin(), paths.end(), std::string{kGameFolder} + "/project.json");
    const std::string where = file.generic_string();
    if (at == paths.end()) return Error{where, "this pack contains no game", ""};
    const Result<std::string> text = (*pack)->read(static_cast<std::size_t>(at - paths.begin()));
    if (!text) return text.error();
    const Result<Project> project = projectFromText(*text, {}, where);
    return project ? Result<std::string>{project->name} : project.error();
}

Result<Done> checkContent(const Project& project, const Path& folder) {
    const std::string content = contentOf(folder);
    if (content.empty()) return Done{};
    const std::string name = folder.generic_string();
    std::error_code none;
    if (!fs::exists(folder / kPackName, none))
        return Error{name, format("the folder has other content: {}", content), "choose an empty folder"};
    const Result<std::string> game = gameIn(folder / kPackName);
    if (!game)
        return Error{name,
                     format("the folder has a {} that no export wrote ({})", kPackName, game.error().what),
                     "choose an empty folder"};
    if (*game == project.name) return Done{};
    return Error{name, format("the folder has an export of another game, \"{}\"", *game),
                 "choose an empty folder, or one with an export of this game"};
}

Error failedAt(const Path& path, const std::error_code& failed, std::string remedy) {
    return Error{path.generic_string(), failed.message(), std::move(remedy)};
}

}  // namespace

Result<ExportFolder> ExportFolder::check(const Project& project, const Path& wanted) {
    std::error_code failed, none;
    const Path whole = fs::absolute(wanted, failed).lexically_normal();
    const Path folder = whole.has_filename() ? whole : whole.parent_path();
    const std::string name = folder.generic_string();
    Path real, root;
    if (!failed) real = fs::weakly_canonical(folder, failed);
    if (!failed) root = fs::weakly_canonical(project.root, failed);
    if (failed) return failedAt(wanted, failed, "choose another folder");
    if (isBelow(real, root))
        return Error{name, "the folder is inside the project", "choose a folder outside the project"};
    if (isBelow(root, real)) return Error{name, "the folder contains the project", "choose another folder"};
    if (!fs::exists(folder, none)) {
        if (!fs::is_symlink(folder, none)) return ExportFolder{folder};
        return Error{name, "this is a link to a folder that does not exist", "choose a folder"};
    }
    if (!fs::is_directory(folder, none))
        return Error{name, "this is a file, not a folder", "choose a folder"};
    if (const Result<Done> good = checkContent(project, folder); !good) return good.error();
    return ExportFolder{folder};
}

Result<Path> ExportFolder::stage() {
    std::error_code failed;
    made_.clear();
    for (Path each = folder_; each.has_relative_path() && !fs::exists(each, failed);
         each = each.parent_path())
        made_ = each;
    fs::remove_all(folder_ / kStage, failed);
    if (!failed) fs::create_directories(folder_ / kStage / kOld, failed);
    if (!failed) fs::create_directories(folder_ / kStage / kNew, failed);
    if (!failed) return folder_ / kStage / kNew;
    clear();
    return failedAt(folder_, failed, "choose another folder, or check the write permission");
}

Result<std::vector<std::string>> ExportFolder::place() {
    const Path fresh = folder_ / kStage / kNew;
    const Path old = folder_ / kStage / kOld;
    std::vector<std::string> files = filesBelow(fresh, "");
    if (const Result<Done> free = checkPlaces(files); !free) return free.error();
    std::vector<std::pair<Path, Path>> moved;  // from, to
    std::error_code failed, none;
    const auto move = [&](const Path& from, const Path& to) {
        fs::create_directories(to.parent_path(), failed);
        if (!failed) fs::rename(from, to, failed);
        if (!failed) moved.emplace_back(from, to);
        return !failed;
    };
    for (const std::string& file : files) {
        const bool isOld = fs::exists(fs::symlink_status(folder_ / file, none));
        if ((!isOld || move(folder_ / file, old / file)) && move(fresh / file, folder_ / file)) continue;
        for (; !moved.empty(); moved.pop_back()) fs::rename(moved.back().second, moved.back().first, none);
        return failedAt(folder_ / file, failed, "close programs that use the folder");
    }
    return files;
}

Result<Done> ExportFolder::checkPlaces(const std::vector<std::string>& files) const {
    std::error_code none;
    for (const std::string& file : files) {
        for (Path place = file; !place.empty(); place = place.parent_path()) {
            const bool wantsFolder = place != Path{file};
            const fs::file_status found = fs::symlink_status(folder_ / place, none);
            if (!fs::exists(found) || fs::is_directory(found) == wantsFolder) continue;
            return Error{(folder_ / place).generic_string(),
                         wantsFolder ? "the export has a folder of this name"
                                     : "this folder is in the place of a file of the export",
                         "rename it, or choose an empty folder"};
        }
    }
    return Done{};
}

void ExportFolder::clear() {
    std::error_code ignored;
    fs::remove_all(folder_ / kStage, ignored);
    for (Path each = folder_; !made_.empty(); each = each.parent_path()) {
        fs::remove(each, ignored);  // not if it has files
        if (each == made_) break;
    }
}

}  // namespace plumb::editor
