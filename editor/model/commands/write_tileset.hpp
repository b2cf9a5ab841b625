#pragma once

#include <string>

#include "assets/asset_store.hpp"
#include "editor/model/document/file_command.hpp"

namespace plumb::editor {

/// Exchanges the text of a tileset's file; all that show the tileset follow. The file is written as a whole
/// or not at all; what goes wrong is in the log.
class WriteTileset final : public FileCommand {
public:
    /// @param assets  outlives the command
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
    std::string text_;  // what is not in the file now
};

}  // namespace plumb::editor
