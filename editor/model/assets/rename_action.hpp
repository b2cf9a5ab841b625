#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/document/file_command.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"

namespace plumb::editor {

/// Renames an input action or axis of the project: in project.json, in all scenes and prefabs that reference
/// it, and in the open document. If writing a file fails, all files are restored.
class RenameAction final : public FileCommand {
public:
    /// @param list     list in project.json: "actions" or "axes"
    /// @param field    name of the component fields that reference it: "action" or "axis"
    /// @param written  called after the files, which may include that of the open scene, were written
    RenameAction(const PrefabEdit& edit, AssetStore& assets, std::string list, std::string field,
                 std::string from, std::string to, std::function<void()> written);

    [[nodiscard]] std::string label() const override;
    void apply(Document& document) override { done_ = rename(document, from_, to_); }
    void revert(Document& document) override {
        if (done_) done_ = !rename(document, to_, from_);
    }

    [[nodiscard]] bool done() const { return done_; }
    [[nodiscard]] const Error& problem() const { return problem_; }  ///< error if not done()
    [[nodiscard]] int places() const { return places_; }  ///< changed references in scenes and prefabs
    [[nodiscard]] std::size_t files() const {
        return last_.size() - 1;
    }  ///< number of changed files besides project.json, after `apply`

private:
    /// A file with its content before and after.
    struct Rewritten {
        std::string path;
        std::string before;
        std::string after;
    };

    bool rename(Document& document, const std::string& from, const std::string& to);
    Result<std::vector<Rewritten>> rewritten(const Document& document, const std::string& from,
                                             const std::string& to);
    Result<Done> writeAll(const std::vector<Rewritten>& files) const;
    void renameInDocument(Document& document, const std::string& from, const std::string& to);

    PrefabEdit edit_;
    AssetStore& assets_;
    std::string list_;
    std::string field_;
    std::string from_;
    std::string to_;
    std::function<void()> written_;
    std::vector<Rewritten> last_;  // files written last, to restore exactly their bytes; project.json first
    Error problem_;
    int places_ = 0;
    bool done_ = false;
};

}  // namespace plumb::editor
