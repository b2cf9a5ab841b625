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

/// Collision shape of a tile. Slopes go "Up" or "Down" from left to right; Low and High are the two halves of
/// a slope that is two tiles long.
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

/// Returns the names of the shapes in files, in the order of the enum. Polygon has none: it is stored as
/// points.
std::span<const std::string_view> tileShapeNames();

struct TileFrame {
    int tile = 0;
    float seconds = 0.1f;

    friend bool operator==(const TileFrame&, const TileFrame&) = default;
};

/// A custom property that only the game uses, e.g. "hazard": true.
using TileProperty = KeptProperty;

/// Data of one tile; tiles without such data are not stored.
struct Tile {
    static constexpr std::size_t kMaxCorners = 256;  ///< of all polygons

    int id = 0;
    TileShape shape = TileShape::None;
    /// Corners, px in the tile; only for TileShape::Polygon. The tile is solid where one of the polygons is;
    /// they may be concave and overlap.
    std::vector<std::vector<Vec2>> polygons;
    bool oneWay = false;               ///< solid only from above, with any shape
    float friction = -1.0f;            ///< negative: the TileCollider's friction
    float bounciness = -1.0f;          ///< negative: the TileCollider's bounciness
    float probability = 1.0f;          ///< weight among variants and in random painting; 0: never selected
    std::string material;              ///< name for the game, e.g. "ice", for sounds and particles
    std::vector<TileFrame> animation;  ///< tiles shown one after another instead of this tile
    std::vector<TileProperty> properties;
    std::vector<KeptProperty> unknown;  ///< unknown members of the file, kept for writing

    /// Returns the JSON text of a property; empty if the tile does not have it.
    [[nodiscard]] std::string_view property(std::string_view name) const;
    [[nodiscard]] bool hasFlag(std::string_view name) const { return property(name) == "true"; }

    friend bool operator==(const Tile&, const Tile&) = default;
};

/// A former or current size of a tileset's image, in tiles. When the image grows, old tiles keep their ids;
/// new tiles get the following ids: first those to the right of the old image, then those below.
struct TilesetSize {
    int columns = 0;
    int rows = 0;

    friend bool operator==(const TilesetSize&, const TilesetSize&) = default;
};

/// The image of one tile, in tilesets that are collections of images.
struct TileImage {
    int tile = 0;
    std::string path;
    TextureId texture;
    Rect source;  ///< region of the image, px; empty: the whole image

    friend bool operator==(const TileImage&, const TileImage&) = default;
};

/// The tiles of a tile layer: position of each in an image, collision, and custom properties. Ids begin at 0.
struct Tileset {
    static constexpr int kFormat = 1;
    static constexpr int kMaxTiles = 1 << 20;

    std::string image;   ///< path of the image of all tiles; empty for a collection of images
    TextureId texture;   ///< id of `image`
    int tileWidth = 16;  ///< px
    int tileHeight = 16;
    int margin = 0;                  ///< px between the image's edge and the tiles
    int spacing = 0;                 ///< px between tiles
    int columns = 1;                 ///< columns of the image when the tileset was created
    int count = 0;                   ///< number of tiles
    std::vector<TilesetSize> sizes;  ///< if the image became wider: all its sizes, the current one last
    Vec2 offset;                     ///< px, added to the position of drawn tiles
    std::vector<TileImage> images;   ///< images of a collection, sorted by tile
    std::vector<Tile> tiles;         ///< tiles with data, sorted by id
    std::vector<Terrain> terrains;   ///< terrains for painting in the editor
    std::vector<TileProperty> properties;
    std::vector<KeptProperty> unknown;  ///< unknown members of the file, kept for writing

    /// Returns the data of a tile; null if it has none. Binary search.
    [[nodiscard]] const Tile* find(int tile) const;
    [[nodiscard]] TileShape shapeOf(int tile) const;

    /// Returns the tile's own image in a collection; null if the tile is in the image of all tiles.
    [[nodiscard]] const TileImage* imageOf(int tile) const;

    /// Returns the region of a tile in the image of all tiles, px.
    [[nodiscard]] Rect sourceOf(int tile) const;

    /// Returns the current number of columns of the image.
    [[nodiscard]] int currentColumns() const { return sizes.empty() ? columns : sizes.back().columns; }
    /// Position of a tile in the image, in tiles.
    struct Place {
        int column = 0;
        int row = 0;
    };
    [[nodiscard]] Place placeOf(int tile) const;
    /// Returns the tile at a position of the image; -1 if there is none.
    [[nodiscard]] int tileAt(Place place) const;
    /// Enlarges the tileset for a larger image. All tiles keep their ids.
    /// @return the number of tiles added
    int growTo(int newColumns, int newRows);

    /// Returns the tile shown for `tile` at a given time: itself, or the current frame of its animation.
    /// @param seconds  time since the scene began
    [[nodiscard]] int shownTile(int tile, double seconds) const;

    friend bool operator==(const Tileset&, const Tileset&) = default;
};

/// Returns the outlines of a tile's shape: its polygons, or one that is convex and clockwise on screen; none
/// for None.
/// @param size  size of the tile, px
std::vector<std::vector<Vec2>> outlinesOf(const Tile& tile, Vec2 size);

/// Reads the text of a `*.tileset.json` file. Invalid parts are reported in `problems` and ignored.
/// @param where  the file's path, for errors
/// @error        the text is not a JSON object, or has a newer format
Result<Tileset> parseTileset(std::string_view json, std::string_view where, std::vector<Error>& problems);

/// Returns the text of a `*.tileset.json` file; parseTileset() of it returns an equal tileset.
std::string writeTileset(const Tileset& tileset);

}  // namespace plumb
