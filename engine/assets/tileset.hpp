#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assets/terrain.hpp"
#include "core/result.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/field_types.hpp"
#include "reflect/json_fields.hpp"

namespace plumb {

/// What a tile is to bodies. "Up" and "Down" are seen from left to right; Low and High are the two halves of
/// a slope that takes two tiles.
enum class TileShape : std::uint8_t {
    None,
    Full,
    OneWay,
    SlopeUp,
    SlopeDown,
    SlopeUpLow,
    SlopeUpHigh,
    SlopeDownHigh,
    SlopeDownLow,
    HalfTop,
    HalfBottom,
    Polygon
};

/// The names of the shapes in files, in the enum's order; a Polygon is written as its points.
std::span<const std::string_view> tileShapeNames();

struct TileFrame {
    int tile = 0;
    float seconds = 0.1f;

    friend bool operator==(const TileFrame&, const TileFrame&) = default;
};

/// A value that only the game understands, e.g. "hazard": true.
using TileProperty = KeptProperty;

/// What is special about one tile of a set.
struct Tile {
    int id = 0;
    TileShape shape = TileShape::None;
    std::vector<Vec2> polygon;         ///< px in the tile, of TileShape::Polygon
    bool oneWay = false;               ///< solid only from above, whatever the shape
    float friction = -1.0f;            ///< negative takes the TileCollider's
    float bounciness = -1.0f;          ///< negative takes the TileCollider's
    float probability = 1.0f;          ///< weight among variants and in random painting; 0 is never chosen
    std::string material;              ///< a word of the game's own, e.g. "ice", for sounds and particles
    std::vector<TileFrame> animation;  ///< shown instead of the tile, in turns
    std::vector<TileProperty> properties;
    std::vector<KeptProperty> unknown;  ///< what the file said and this program does not know; written back

    /// The property's JSON text; empty when there is none.
    [[nodiscard]] std::string_view property(std::string_view name) const;
    [[nodiscard]] bool hasFlag(std::string_view name) const { return property(name) == "true"; }

    friend bool operator==(const Tile&, const Tile&) = default;
};

/// A size that a set's picture has had, in tiles. When it grows what was there keeps its numbers; new tiles
/// follow the last one, first those to the right of the old picture, then those below.
struct TilesetSize {
    int columns = 0;
    int rows = 0;

    friend bool operator==(const TilesetSize&, const TilesetSize&) = default;
};

/// A picture of its own for one tile, in sets that are collections of images.
struct TileImage {
    int tile = 0;
    std::string path;
    TextureId texture;
    Rect source;  ///< px in the picture; empty means all of it

    friend bool operator==(const TileImage&, const TileImage&) = default;
};

/// The tiles that layers are made of: where each is in a picture, and what it means. Tiles count from 0.
struct Tileset {
    static constexpr int kFormat = 1;
    static constexpr int kMaxTiles = 1 << 20;

    std::string image;   ///< path; empty for a collection
    TextureId texture;   ///< of `image`
    int tileWidth = 16;  ///< px
    int tileHeight = 16;
    int margin = 0;   ///< px around all tiles of the picture
    int spacing = 0;  ///< px between them
    int columns = 1;  ///< in the picture, when the set was made
    int count = 0;
    std::vector<TilesetSize> sizes;  ///< of a picture that became wider: the first one up to that of now
    Vec2 offset;                     ///< px added where tiles are drawn
    std::vector<TileImage> images;   ///< of a collection, by tile
    std::vector<Tile> tiles;         ///< those with something special, by id
    std::vector<Terrain> terrains;   ///< what the editor paints as a whole
    std::vector<TileProperty> properties;
    std::vector<KeptProperty> unknown;

    /// What is special about a tile; null when nothing is. A binary search.
    [[nodiscard]] const Tile* find(int tile) const;
    [[nodiscard]] TileShape shapeOf(int tile) const;

    /// The picture of its own that a tile has; null when it is in the common one.
    [[nodiscard]] const TileImage* imageOf(int tile) const;

    /// Where a tile is in the common picture (px).
    [[nodiscard]] Rect sourceOf(int tile) const;

    /// The picture's columns now, and where a tile is in it, in tiles.
    [[nodiscard]] int columnsNow() const { return sizes.empty() ? columns : sizes.back().columns; }
    struct Place {
        int column = 0;
        int row = 0;
    };
    [[nodiscard]] Place placeOf(int tile) const;
    /// The tile at a place of the picture; -1 where there is none.
    [[nodiscard]] int tileAt(Place place) const;
    /// Takes in a picture with more room. The numbers of all tiles stay.
    /// @return how many tiles came to it
    int growTo(int newColumns, int newRows);

    /// The tile that is shown for `tile` at a time: itself, or the frame of its animation.
    /// @param seconds  since the scene began
    [[nodiscard]] int shownTile(int tile, double seconds) const;

    friend bool operator==(const Tileset&, const Tileset&) = default;
};

/// The outline of a tile's shape, clockwise on screen, convex but for polygons; empty for None.
/// @param size  px of the tile
std::vector<Vec2> outlineOf(const Tile& tile, Vec2 size);

/// Reads `*.tileset.json`. What is wrong inside is listed in `problems` and left out.
/// @param where  the file's path, for errors
/// @error        the text is no JSON object, or of a newer format
Result<Tileset> parseTileset(std::string_view json, std::string_view where, std::vector<Error>& problems);

/// The text of `*.tileset.json`; reading it gives the same tileset.
std::string writeTileset(const Tileset& tileset);

}  // namespace plumb
