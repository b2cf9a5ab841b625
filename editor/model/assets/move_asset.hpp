#pragma once

#include <functional>
#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "core/file.hpp"
#include "editor/model/document/file_command.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// Gives a file or a folder of the project another path, in all files that name it and in the open scene.
/// Either everything is written or nothing: what goes wrong is put back and reported in the log.
class MoveAsset final : public FileCommand {
public:
    /// @param edit  its parts outlive the command
    MoveAsset(const PrefabEdit& edit, AssetStore& assets, std::string from, std::string to,
              std::function<void()> written);

    [[nodiscard]] std::string label() const override;
    void apply(Document& document) override { moved_ = move(document, from_, to_); }
    void revert(Document& document) override {
        if (moved_) moved_ = !move(document, to_, from_);
    }

private:
    /// A file that named the asset, with its bytes on both sides.
    struct Rewritten {
        std::string path;
        std::string before;
        std::string after;
    };

    /// @return whether it worked
    bool move(Document& document, const std::string& from, const std::string& to);
    Result<Done> moveFiles(const std::string& from, const std::string& to);
    std::vector<Rewritten> rewritten(const std::string& from, const std::string& to) const;

    PrefabEdit edit_;
    AssetStore& assets_;
    std::string from_;
    std::string to_;
    bool folder_ = false;
    bool moved_ = false;
    std::function<void()> written_;
    std::vector<Rewritten> last_;  // what the last move wrote, to give the very bytes back
};

/// Renames or moves a file or a folder of the project, as one step of undo.
/// @param to       path in the project; a new name keeps the ending
/// @param written  called after the files were written, by redo and undo too: the file of the open scene may
/// be
///                 among them
/// @error     no such file, the name is taken, or it leaves the project; nothing has changed then
Result<Done> moveAsset(const PrefabEdit& edit, AssetStore& assets, std::string_view from, std::string_view to,
                       std::function<void()> written = nullptr);

/// Takes a file out of the project, as one step of undo: undo puts it back. What names it keeps the name.
/// @error  no such file, or it is a folder that is not empty
Result<Done> deleteAsset(const PrefabEdit& edit, std::string_view path);

}  // namespace plumb::editor
