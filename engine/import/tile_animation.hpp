#pragma once

#include <map>
#include <string>
#include <utility>

#include "import/import_tilesets.hpp"

namespace plumb {

/// The tile that an animated tile shows at the beginning: itself, or its first frame.
int shownTile(const tiled::Tileset& tileset, int id);

/// The animation files of tiles that stand as objects: the frames of each are put side by side in a picture.
class TileAnimations {
public:
    struct Made {
        std::string file;     ///< path in the project; empty when it could not be made
        std::string texture;  ///< path of the frames' picture
    };

    /// The animation of a tile; null when the tile is not animated.
    const Made* of(const ImportedTileset& tileset, int id, ImportStage& stage);

private:
    std::map<std::pair<const tiled::Tileset*, int>, Made> made_;
};

}  // namespace plumb
