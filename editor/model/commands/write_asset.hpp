#pragma once

#include <string>

#include "assets/asset_store.hpp"
#include "core/file.hpp"
#include "editor/model/document/file_command.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Replaces the text of a project file, or creates the file, and reloads it where it is used. Undo restores
/// exactly the old bytes.
class WriteAsset final : public FileCommand {
public:
    /// @param root, assets  must outlive the command
    WriteAsset(std::string label, const Path& root, AssetStore& assets, std::string path, std::string text)
        : label_{std::move(label)},
          root_{root},
          assets_{assets},
          path_{std::move(path)},
          text_{std::move(text)} {}

    [[nodiscard]] std::string label() const override { return label_; }
    void apply(Document&) override { swap(); }
    void revert(Document&) override { swap(); }

private:
    void swap();

    std::string label_;
    const Path& root_;
    AssetStore& assets_;
    std::string path_;
    std::string text_;   // text to swap in: the new one, after `apply` the old one
    bool there_ = true;  // true: the file exists after the next swap
};

}  // namespace plumb::editor
