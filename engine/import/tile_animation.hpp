#pragma once

#include <map>
#include <string>
#include <utility>

#include "import/import_tilesets.hpp"

namespace plumb {

/// Returns the tile to show for a tile without playing its animation: its first frame, or itself without one.
int shownTile(const tiled::Tileset& tileset, int id);

/// Makes animation files for animated tiles used as objects, each with an image of all frames side by side.
class TileAnimations {
public:
    struct StagedAnimation {
        std::string file;     ///< path of the animation in the project; empty if it could not be made
        std::string texture;  ///< path of the image with the frames
    };

    /// Returns the animation of a tile, made at the first call for it; null if the tile is not animated.
    const StagedAnimation* of(const ImportedTileset& tileset, int id, ImportStage& stage);

private:
    std::map<std::pair<const tiled::Tileset*, int>, StagedAnimation> made_;
};

}  // namespace plumb
