#include "editor/model/commands/write_tileset.hpp"

#include <utility>

#include "core/file.hpp"
#include "core/log.hpp"

namespace plumb::editor {

bool WriteTileset::absorb(const Command& next) {
    const auto* other = dynamic_cast<const WriteTileset*>(&next);
    // This command keeps the text from before the gesture; the later ones are in the file.
    return other != nullptr && other->tileset_ == tileset_ && other->label_ == label_;
}

void WriteTileset::swap() {
    const Result<Path> file = assets_.resolve(assets_.pathOf(tileset_));
    if (!file) return logError("Editor", file.error());
    Result<std::string> before = readFile(*file);
    if (!before) return logError("Editor", before.error());
    if (const Result<Done> written = writeFile(*file, text_); !written)
        return logError("Editor", written.error());
    text_ = *std::move(before);
    assets_.refresh(AssetKind::Tileset, tileset_.path);
}

}  // namespace plumb::editor
