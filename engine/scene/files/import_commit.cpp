#include "scene/files/import_commit.hpp"

#include <optional>
#include <utility>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kList = "list.json";

Path folderOf(const Path& root) { return root / ".plumb" / "import"; }

/// A file to move to its final path.
struct Move {
    Path from;
    Path to;
    Path old;  ///< backup of the file at `to`, for undo; empty if there was none
};

std::string listText(const std::vector<ImportedFile>& files) {
    Json list = Json::array();
    for (const ImportedFile& file : files) list.push_back(file.path);
    Json json = Json::object();
    json["files"] = std::move(list);
    return writeJson(json);
}

Error importError(const std::string& path, std::string why) {
    return {path, std::move(why),
            "make the path writable or free it, then import again; nothing was changed"};
}

/// Returns the moves of all files, after checking that their paths are valid.
Result<std::vector<Move>> planned(const Path& root, const std::vector<ImportedFile>& files) {
    std::vector<Move> moves;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Result<Path> to = pathInside(root, files[i].path);
        if (!to) return to.error();
        std::error_code failed;
        if (fs::is_directory(*to, failed))
            return importError(files[i].path, "a folder with this name exists");
        moves.push_back({folderOf(root) / std::to_string(i), *to, {}});
    }
    return moves;
}

/// Writes the files and backups of those they replace to the import folder.
Result<Done> stage(const Path& root, const std::vector<ImportedFile>& files, std::vector<Move>& moves) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (const Result<Done> written = writeFile(moves[i].from, files[i].bytes); !written)
            return written.error();
        std::error_code failed;
        fs::create_directories(moves[i].to.parent_path(), failed);
        if (failed) return importError(files[i].path, "cannot create its folder: " + failed.message());
        if (!fs::exists(moves[i].to, failed)) continue;
        moves[i].old = folderOf(root) / (std::to_string(i) + ".old");
        fs::copy_file(moves[i].to, moves[i].old, fs::copy_options::overwrite_existing, failed);
        if (failed)
            return importError(files[i].path, "cannot back up the existing file: " + failed.message());
    }
    return writeFile(folderOf(root) / kList, listText(files));
}

void undo(const std::vector<Move>& moves, std::size_t count) {
    std::error_code failed;
    for (std::size_t i = 0; i < count; ++i) {
        if (moves[i].old.empty()) {
            fs::remove(moves[i].to, failed);
        } else {
            fs::rename(moves[i].old, moves[i].to, failed);
        }
    }
}

Result<Done> moveAll(const std::vector<Move>& moves) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
        std::error_code failed;
        fs::rename(moves[i].from, moves[i].to, failed);
        if (!failed) continue;
        undo(moves, i);
        return importError(moves[i].to.generic_string(), "cannot replace the file: " + failed.message());
    }
    return Done{};
}

void clear(const Path& root) {
    std::error_code failed;
    fs::remove(folderOf(root) / kList,
               failed);  // first, so that a partial set of files is never taken for complete
    fs::remove_all(folderOf(root), failed);
    fs::remove(root / ".plumb", failed);  // succeeds only if it is empty
}

}  // namespace

Result<Done> commitImport(const Path& root, const std::vector<ImportedFile>& files) {
    finishImport(root);
    clear(root);
    Result<std::vector<Move>> moves = planned(root, files);
    if (!moves) return moves.error();
    Result<Done> done = stage(root, files, *moves);
    if (done) done = moveAll(*moves);
    clear(root);
    return done;
}

void finishImport(const Path& root) {
    std::error_code failed;
    if (!fs::exists(folderOf(root) / kList, failed)) return;
    const Result<std::string> text = readFile(folderOf(root) / kList);
    const Result<Json> json = text ? parseJson(*text, kList) : Result<Json>{text.error()};
    const Json* files = json ? findArray(*json, "files") : nullptr;
    for (std::size_t i = 0; files != nullptr && i < files->size(); ++i) {
        const Result<Path> to = pathInside(root, stringOrEmpty((*files)[i]));
        if (to) fs::rename(folderOf(root) / std::to_string(i), *to, failed);
    }
    clear(root);
}

}  // namespace plumb
