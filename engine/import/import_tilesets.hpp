#pragma once

#include <map>
#include <string>

#include "import/import_stage.hpp"
#include "import/tiled_map.hpp"
#include "math/rect.hpp"

namespace plumb {

/// Image and region of one tile.
struct TileRegion {
    std::string texture;  ///< path in the project
    Rect source;          ///< region of the texture, px
};

/// A tileset of a map and the tileset file made from it.
struct ImportedTileset {
    std::string path;       ///< in the project
    int count = 0;          ///< number of tiles; 0: unknown, because the image is missing
    bool collides = false;  ///< at least one tile has a collision shape

    const tiled::Tileset* original = nullptr;
    StagedImage image;                   ///< image of all tiles; empty for a collection of images
    std::map<int, TileRegion> pictures;  ///< image of each tile of a collection, by tile id

    /// Returns the image and region of a tile; empty if the tileset has no such tile.
    [[nodiscard]] TileRegion pictureOf(int id) const;
    /// True for a tile that was deleted from a collection of images, or never was in it.
    [[nodiscard]] bool isDeleted(int id) const;
    /// Returns the size of a tile's image, px; without an image the size that the tileset declares.
    [[nodiscard]] Vec2 sizeOf(int id) const;
    /// Returns the factor by which a map draws a tile larger than its image.
    [[nodiscard]] Vec2 scaleIn(const tiled::Map& map, int id) const;
};

/// Adds a tileset file and copies of its images to the stage. Tiles of another size than the map's cells keep
/// their size and are aligned to the lower left corner of their cell.
ImportedTileset importTileset(const tiled::Map& map, const tiled::Tileset& tileset, ImportStage& stage);

}  // namespace plumb
