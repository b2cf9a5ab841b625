#pragma once

#include <string>

#include "assets/asset_store.hpp"
#include "editor/model/document/file_command.hpp"

namespace plumb::editor {

/// Replaces the text of a tileset's file and reloads the tileset where it is used. The file is written
/// completely or not at all; errors are logged.
class WriteTileset final : public FileCommand {
public:
    /// @param assets  must outlive the command
    WriteTileset(std::string label, AssetStore& assets, TilesetId tileset, std::string text)
        : label_{std::move(label)}, assets_{assets}, tileset_{tileset}, text_{std::move(text)} {}

    [[nodiscard]] std::string label() const override { return label_; }
    void apply(Document&) override { swap(); }
    void revert(Document&) override { swap(); }
    bool absorb(const Command& next) override;

private:
    void swap();

    std::string label_;
    AssetStore& assets_;
    TilesetId tileset_;
    std::string text_;  // text to swap in: the new one, after `apply` the old one
};

}  // namespace plumb::editor
