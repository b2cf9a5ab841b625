#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assets/tileset.hpp"

namespace plumb::editor {

class Workspace;

// Edits of tileset data without undo; changeTileset() makes one a step of undo.

/// What is special about a tile, to be changed; made when there was nothing.
Tile& tileIn(Tileset& tileset, int tile);
/// Leaves out tiles with nothing special any more.
void tidy(Tileset& tileset);

void setShape(Tileset& tileset, std::span<const int> tiles, TileShape shape);
/// @param points  px in the tile
void setPolygon(Tileset& tileset, std::span<const int> tiles, const std::vector<Vec2>& points);
/// @param json  the value as JSON text; empty takes the property away
void setProperty(Tileset& tileset, std::span<const int> tiles, std::string_view name, std::string_view json);

/// What a person typed as JSON text: numbers, true and false as such, all else as a text.
std::string propertyJson(std::string_view typed);

/// The numbers of tiles whose number, material, shape or properties contain the words; all for no words.
std::vector<int> tilesFound(const Tileset& tileset, std::string_view words);

// Terrain.

/// A new terrain with a name and a colour of its own, without tiles.
Terrain& addTerrain(Tileset& tileset, TerrainMode mode);
/// How the tiles of a terrain usually lie in a picture.
enum class TerrainLayout : unsigned char {
    InOrder,     ///< by rising masks: 47, or 16
    FourByFour,  ///< a 3x3 block, a column of one tile's width, a row of one tile's height; one tile alone
    Block        ///< the 3x3 block alone
};
std::span<const std::string_view> terrainLayoutNames();
/// Gives the tiles their masks as they lie, from the first one on.
/// @param chosen  in rows, as they lie in the palette
void assignMasks(Terrain& terrain, const Tileset& tileset, std::span<const int> chosen, TerrainLayout layout);
/// Gives tiles one mask, or takes them out of the terrain.
void setMask(Terrain& terrain, std::span<const int> tiles, int mask);
/// The mask of a tile in the terrain; -1 when it does not belong to it.
int maskOf(const Terrain& terrain, int tile);

/// Writes the tileset of the layer in hand, changed, to its file, as one step of undo.
/// @return false, with a notice, when it has no file
bool changeTileset(Workspace& workspace, std::string label, const std::function<void(Tileset&)>& change);

}  // namespace plumb::editor
