#pragma once

#include <string>

#include "assets/asset_store.hpp"
#include "core/file.hpp"
#include "editor/model/document/file_command.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Exchanges the text of a file of the project, at once and as a whole; what shows it follows. Undo gives the
/// very bytes back.
class WriteAsset final : public FileCommand {
public:
    /// @param root, assets  outlive the command
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
    std::string text_;   // what is not in the file now
    bool there_ = true;  // whether a file shall be there after the next swap
};

}  // namespace plumb::editor
