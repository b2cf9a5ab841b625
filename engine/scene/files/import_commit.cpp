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

/// One file on its way to its place.
struct Move {
    Path from;
    Path to;
    Path old;  ///< what was there before, to be put back; empty when nothing was
};

std::string listText(const std::vector<ImportedFile>& files) {
    Json list = Json::array();
    for (const ImportedFile& file : files) list.push_back(file.path);
    Json json = Json::object();
    json["files"] = std::move(list);
    return writeJson(json);
}

Error cannotStand(const std::string& path, std::string why) {
    return {path, std::move(why), "make room for it in the project, and import again; nothing was changed"};
}

/// Where everything goes, with the proof that it can.
Result<std::vector<Move>> planned(const Path& root, const std::vector<ImportedFile>& files) {
    std::vector<Move> moves;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Result<Path> to = pathInside(root, files[i].path);
        if (!to) return to.error();
        std::error_code failed;
        if (fs::is_directory(*to, failed))
            return cannotStand(files[i].path, "a folder of this name is there");
        moves.push_back({folderOf(root) / std::to_string(i), *to, {}});
    }
    return moves;
}

/// Writes the files, and keeps what they will replace, beside the project's own.
Result<Done> stage(const Path& root, const std::vector<ImportedFile>& files, std::vector<Move>& moves) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (const Result<Done> written = writeFile(moves[i].from, files[i].bytes); !written)
            return written.error();
        std::error_code failed;
        fs::create_directories(moves[i].to.parent_path(), failed);
        if (failed) return cannotStand(files[i].path, "its folder cannot be made: " + failed.message());
        if (!fs::exists(moves[i].to, failed)) continue;
        moves[i].old = folderOf(root) / (std::to_string(i) + ".old");
        fs::copy_file(moves[i].to, moves[i].old, fs::copy_options::overwrite_existing, failed);
        if (failed) return cannotStand(files[i].path, "it cannot be read: " + failed.message());
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
        return cannotStand(moves[i].to.generic_string(), "it could not be replaced: " + failed.message());
    }
    return Done{};
}

void clear(const Path& root) {
    std::error_code failed;
    fs::remove(folderOf(root) / kList, failed);  // first, so that no half of the files is taken for all
    fs::remove_all(folderOf(root), failed);
    fs::remove(root / ".plumb", failed);  // only when it is empty
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
        const Result<Path> to = pathInside(root, textOrEmpty((*files)[i]));
        if (to) fs::rename(folderOf(root) / std::to_string(i), *to, failed);
    }
    clear(root);
}

}  // namespace plumb
