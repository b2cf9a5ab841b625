#pragma once

#include <map>
#include <string>

#include "import/import_stage.hpp"
#include "import/tiled_map.hpp"
#include "math/rect.hpp"

namespace plumb {

/// Where the picture of one tile is.
struct TilePicture {
    std::string texture;  ///< path in the project
    Rect source;          ///< px
};

/// A tileset of a map and the file that it became.
struct ImportedTileset {
    std::string path;  ///< in the project
    int count = 0;
    bool collides = false;  ///< some tile has a shape

    const tiled::Tileset* original = nullptr;
    StagedImage image;                    ///< of all tiles; empty for a collection
    std::map<int, TilePicture> pictures;  ///< of a collection, by id

    /// The picture of a tile; nothing in it when the set has no such tile.
    [[nodiscard]] TilePicture pictureOf(int id) const;
};

/// Writes a tileset and copies its pictures. Tiles of another size than the map's cells keep their size and
/// stand on the lower left corner of their cell.
ImportedTileset importTileset(const tiled::Map& map, const tiled::Tileset& tileset, ImportStage& stage);

}  // namespace plumb
