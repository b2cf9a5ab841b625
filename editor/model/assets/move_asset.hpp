#pragma once

#include <functional>
#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "core/file.hpp"
#include "editor/model/document/file_command.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// Moves or renames a file or folder of the project and updates its path in all files that reference it and
/// in the open scene. If any step fails, everything is restored and the error is logged.
class MoveAsset final : public FileCommand {
public:
    /// @param edit  its document, undo stack and prefabs must outlive the command
    MoveAsset(const PrefabEdit& edit, AssetStore& assets, std::string from, std::string to,
              std::function<void()> written);

    [[nodiscard]] std::string label() const override;
    void apply(Document& document) override { moved_ = move(document, from_, to_); }
    void revert(Document& document) override {
        if (moved_) moved_ = !move(document, to_, from_);
    }

private:
    /// A file that references the asset, with its content before and after the move.
    struct Rewritten {
        std::string path;
        std::string before;
        std::string after;
    };

    /// @return true on success
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
    std::vector<Rewritten> last_;  // files written by the last move, to restore exactly their bytes
};

/// Renames or moves a file or a folder of the project, as one undo step.
/// @param to       path in the project, with the file's extension
/// @param written  called after each apply, undo and redo has written files, which may include the open
///                 scene's
/// @error     the file does not exist, `to` exists or is outside the project; nothing has changed then
Result<Done> moveAsset(const PrefabEdit& edit, AssetStore& assets, std::string_view from, std::string_view to,
                       std::function<void()> written = nullptr);

/// Deletes a file or an empty folder of the project, as one undo step. References to it are kept.
/// @error  the file does not exist, or the folder is not empty
Result<Done> deleteAsset(const PrefabEdit& edit, std::string_view path);

}  // namespace plumb::editor
