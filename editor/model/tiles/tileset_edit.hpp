#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assets/tileset.hpp"

namespace plumb::editor {

class Workspace;

// Edits of tileset data without undo; changeTileset() makes an undo step of them.

/// Returns the data of a tile for changing; adds a default entry if the tileset has none.
Tile& tileIn(Tileset& tileset, int tile);
/// Removes entries of tiles that have only default values.
void tidy(Tileset& tileset);

/// Sets the collision shape of tiles, and removes their polygons.
void setShape(Tileset& tileset, std::span<const int> tiles, TileShape shape);
/// Sets polygons as the collision shape of tiles; those of fewer than 3 points are left out, and without any
/// the tiles have no shape. @param polygons  px in the tile
void setPolygons(Tileset& tileset, std::span<const int> tiles, std::vector<std::vector<Vec2>> polygons);
/// Sets a property of tiles. @param json  the value as JSON text; empty removes the property
void setProperty(Tileset& tileset, std::span<const int> tiles, std::string_view name, std::string_view json);

/// Converts the user's input to JSON text: valid JSON stays, other text becomes a string, empty input becomes
/// true.
std::string propertyJson(std::string_view typed);

/// Returns the ids of the tiles whose id is `words`, or whose material, shape or properties contain this
/// text; all tiles if `words` is empty.
std::vector<int> tilesFound(const Tileset& tileset, std::string_view words);

// Terrain.

/// Adds a terrain without tiles, with a new name and color.
Terrain& addTerrain(Tileset& tileset, TerrainMode mode);
/// Common arrangements of a terrain's tiles in an image.
enum class TerrainLayout : unsigned char {
    InOrder,     ///< tiles sorted by ascending masks; 47 or 16 tiles, depending on the terrain's mode
    FourByFour,  ///< a 3x3 block, a column of terrain one cell wide, a row one cell high, a single cell
    Block        ///< only the 3x3 block
};
/// Names of the layouts for display, in the order of the enum.
std::span<const std::string_view> terrainLayoutNames();
/// Replaces the terrain's tiles, with masks by their position in the layout relative to the first tile.
/// @param chosen  ids of the tiles, row by row as in the palette
void assignMasks(Terrain& terrain, const Tileset& tileset, std::span<const int> chosen, TerrainLayout layout);
/// Sets the mask (bits of equal neighbors) of tiles in the terrain. @param mask  none: removes the tiles
void setMask(Terrain& terrain, std::span<const int> tiles, std::optional<std::uint8_t> mask);
/// Returns the mask of a tile in the terrain; none if the tile is not part of it.
std::optional<std::uint8_t> maskOf(const Terrain& terrain, int tile);

/// Applies `change` to the active layer's tileset and writes its file, as one undo step.
/// @return false if nothing changed, or, with a notice to the user, if the tileset has no file in the project
bool changeTileset(Workspace& workspace, std::string label, const std::function<void(Tileset&)>& change);

}  // namespace plumb::editor
