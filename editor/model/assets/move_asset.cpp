#include "editor/model/assets/move_asset.hpp"

#include <algorithm>

#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/assets/asset_uses.hpp"
#include "editor/model/assets/reload_document.hpp"
#include "editor/model/document/prefab_file.hpp"

namespace plumb::editor {
namespace {

SceneContext contextOf(const PrefabEdit& edit) { return {edit.document.types(), edit.prefabs, edit.root}; }

std::string nameOf(std::string_view path) { return std::string{path.substr(path.rfind('/') + 1)}; }

/// Returns the path of a file after `from`, which is the file itself or a folder, was moved to `to`.
std::string movedPath(const std::string& path, const std::string& from, const std::string& to) {
    if (path == from) return to;
    return startsWith(path, from + "/") ? to + path.substr(from.size()) : path;
}

/// Deletes a file or an empty folder. The file's content is kept in memory for undo.
class DeleteAsset final : public FileCommand {
public:
    DeleteAsset(Path root, std::string path) : root_{std::move(root)}, path_{std::move(path)} {}

    [[nodiscard]] std::string label() const override { return format("delete {}", nameOf(path_)); }
    void apply(Document&) override {
        std::error_code failed;
        const Path file = root_ / path_;
        folder_ = std::filesystem::is_directory(file, failed);
        if (!folder_) {
            Result<std::string> bytes = readFile(file);
            if (!bytes) return logError("Editor", bytes.error());
            bytes_ = *std::move(bytes);
        }
        std::filesystem::remove(file, failed);
        if (failed) logError("Editor", Error{path_, failed.message(), "close programs that use the file"});
    }
    void revert(Document&) override {
        std::error_code failed;
        if (folder_) {
            std::filesystem::create_directories(root_ / path_, failed);
        } else if (const Result<Done> written = writeFile(root_ / path_, bytes_); !written) {
            logError("Editor", written.error());
        }
    }

private:
    Path root_;
    std::string path_;
    std::string bytes_;
    bool folder_ = false;
};

}  // namespace

MoveAsset::MoveAsset(const PrefabEdit& edit, AssetStore& assets, std::string from, std::string to,
                     std::function<void()> written)
    : edit_{edit}, assets_{assets}, from_{std::move(from)}, to_{std::move(to)}, written_{std::move(written)} {
    std::error_code ignored;
    folder_ = std::filesystem::is_directory(edit_.root / from_, ignored);
}

std::string MoveAsset::label() const { return format("rename {} to {}", nameOf(from_), nameOf(to_)); }

std::vector<MoveAsset::Rewritten> MoveAsset::rewritten(const std::string& from, const std::string& to) const {
    std::vector<Rewritten> files;
    for (const AssetUse& use : usesOfAsset(edit_.root, from, folder_)) {
        Result<std::string> before = readFile(edit_.root / use.file);
        if (!before) continue;
        // A file that this command wrote gets back exactly its bytes from before.
        const auto known = std::find_if(last_.begin(), last_.end(), [&](const Rewritten& last) {
            return last.path == use.file && last.after == *before;
        });
        std::string after =
            known != last_.end() ? known->before : withRenamedAsset(*before, from, to, folder_);
        files.push_back({use.file, *std::move(before), std::move(after)});
    }
    return files;
}

Result<Done> MoveAsset::moveFiles(const std::string& from, const std::string& to) {
    std::vector<Rewritten> files = rewritten(from, to);
    std::error_code failed;
    const Path target = edit_.root / to;
    if (std::filesystem::exists(target, failed))
        return Error{to, "a file with this name exists now", "rename that file first"};
    std::filesystem::create_directories(target.parent_path(), failed);
    std::filesystem::rename(edit_.root / from, target, failed);
    if (failed) return Error{from, failed.message(), "check that the folder is writable"};
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Result<Done> written =
            writeFile(edit_.root / movedPath(files[i].path, from, to), files[i].after);
        if (written) continue;
        for (std::size_t done = 0; done < i; ++done) {
            static_cast<void>(
                writeFile(edit_.root / movedPath(files[done].path, from, to), files[done].before).ok());
        }
        std::filesystem::rename(target, edit_.root / from, failed);
        return written.error();
    }
    for (Rewritten& file : files) file.path = movedPath(file.path, from, to);
    last_ = std::move(files);
    return Done{};
}

bool MoveAsset::move(Document& document, const std::string& from, const std::string& to) {
    if (const Result<Done> moved = moveFiles(from, to); !moved) {
        logError("Editor", moved.error());
        return false;
    }
    const SceneContext context = contextOf(edit_);
    if (document.scenePath.empty()) return true;
    const std::string text = fileText(document.world, context, document.scene);
    document.scenePath = movedPath(document.scenePath, from, to);
    if (edit_.prefabs != nullptr) edit_.prefabs->forget();
    const Result<LoadReport> loaded =
        reloadDocument(document, context, withRenamedAsset(text, from, to, folder_));
    if (!loaded) logError("Editor", loaded.error());
    static_cast<void>(assets_.pollChanges(assets_.size()));
    if (written_) written_();
    return true;
}

Result<Done> moveAsset(const PrefabEdit& edit, AssetStore& assets, std::string_view from, std::string_view to,
                       std::function<void()> written) {
    const Result<Path> source = pathInside(edit.root, from);
    const Result<Path> target = pathInside(edit.root, to);
    if (!source) return source.error();
    if (!target) return target.error();
    std::error_code ignored;
    if (!std::filesystem::exists(*source, ignored))
        return Error{std::string{from}, "the file does not exist", "refresh the folder"};
    if (from == to) return Done{};
    if (to.empty() || endsWith(to, "/")) return Error{std::string{to}, "the name is empty", "enter a name"};
    if (std::filesystem::exists(*target, ignored))
        return Error{std::string{to}, "a file with this name exists", "choose another name"};
    if (startsWith(to, std::string{from} + "/"))
        return Error{std::string{to}, "a folder cannot be moved into itself", "choose another folder"};
    edit.undo.endGesture();
    edit.undo.push(
        std::make_unique<MoveAsset>(edit, assets, std::string{from}, std::string{to}, std::move(written)));
    edit.undo.endGesture();
    if (std::filesystem::exists(*target, ignored)) return Done{};
    edit.undo.undo();
    return Error{std::string{from}, "it could not be renamed", "see the console for the reason"};
}

Result<Done> deleteAsset(const PrefabEdit& edit, std::string_view path) {
    const Result<Path> file = pathInside(edit.root, path);
    if (!file) return file.error();
    std::error_code ignored;
    if (!std::filesystem::exists(*file, ignored))
        return Error{std::string{path}, "the file does not exist", "refresh the folder"};
    if (std::filesystem::is_directory(*file, ignored) && !std::filesystem::is_empty(*file, ignored))
        return Error{std::string{path}, "the folder is not empty", "delete its content first"};
    edit.undo.endGesture();
    edit.undo.push(std::make_unique<DeleteAsset>(edit.root, std::string{path}));
    edit.undo.endGesture();
    return Done{};
}

}  // namespace plumb::editor
