#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

/// A Tiled map as read from its files, before conversion to a scene. Units: px, degrees, ms, as in the files.
namespace plumb::tiled {

/// Global tile id of a cell, unique over all tilesets of a map, with four flip and rotation bits; 0 is empty.
using Gid = std::uint32_t;

inline constexpr Gid kFlipX = 0x80000000u;
inline constexpr Gid kFlipY = 0x40000000u;
inline constexpr Gid kFlipDiagonal = 0x20000000u;
inline constexpr Gid kRotateHex = 0x10000000u;  ///< used only by hexagonal maps
inline constexpr Gid kFlags = kFlipX | kFlipY | kFlipDiagonal | kRotateHex;

/// Reference to a tile of one tileset, or to none.
struct TileRef {
    int tileset = -1;  ///< index in Map::tilesets
    int id = 0;
    Gid flags = 0;

    [[nodiscard]] bool empty() const { return tileset < 0; }
    friend bool operator==(const TileRef&, const TileRef&) = default;
};

enum class Shape : std::uint8_t { Rectangle, Ellipse, Point, Capsule, Polygon, Polyline, Text, Tile };

struct TextStyle {
    std::string text;
    std::string font = "sans-serif";
    double size = 16.0;  ///< px
    Color color{0, 0, 0, 255};
    bool wrap = false;
    bool bold = false;
    bool italic = false;
    bool underline = false;
    bool strikeout = false;
    bool kerning = true;
    std::string alignX = "left";
    std::string alignY = "top";
};

struct Object {
    int id = 0;
    std::string name;
    std::string type;  ///< "class" in files of Tiled 1.9
    Shape shape = Shape::Rectangle;
    double x = 0.0;  ///< px; (x, y) is also the center of rotation
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
    double rotation = 0.0;  ///< degrees, clockwise
    double opacity = 1.0;
    bool visible = true;
    TileRef tile;              ///< tile; only for Shape::Tile
    std::vector<Vec2> points;  ///< corners of polygons and polylines, px from (x, y)
    TextStyle text;
    std::string templateFile;  ///< path of its template as written in the map; empty: none
    Json properties = Json::object();
};

struct Frame {
    int tile = 0;
    int milliseconds = 0;
};

/// The tileset's data for one of its tiles.
struct Tile {
    int id = 0;
    std::string type;
    std::string image;           ///< image of this tile only, relative to the tileset's folder; empty: none
    std::optional<Rect> source;  ///< region of the image, px; without value: the whole image
    std::optional<Color> transparent;  ///< color key: pixels of this color become transparent
    int width = 0;                     ///< image size, px, according to the file; 0 if the file has none
    int height = 0;
    double probability = 1.0;
    std::vector<Frame> animation;
    std::vector<Object> collision;
    Json properties = Json::object();
    std::string terrain;  ///< terrain in the format used before Tiled 1.5; kept as data
};

struct Tileset {
    Gid firstGid = 1;
    std::string name;
    std::string type;
    Path folder;           ///< image paths are relative to this folder
    Path file;             ///< file of an external tileset; empty for an embedded one
    bool missing = false;  ///< the external file cannot be read
    int tileWidth = 0;     ///< px
    int tileHeight = 0;
    int spacing = 0;
    int margin = 0;
    int count = 0;    ///< number of tiles; 0 if the file has none
    int columns = 0;  ///< 0 if the file has none
    int offsetX = 0;  ///< px
    int offsetY = 0;
    int isometricWidth = 0;  ///< px: cell of the isometric grid in which collision shapes were drawn; 0: none
    int isometricHeight = 0;
    std::string objectAlignment;       ///< empty: bottom-left
    bool fitsGrid = false;             ///< tiles are stretched to the cell
    bool keepsAspect = false;          ///< with fitsGrid: the aspect ratio is kept
    std::string image;                 ///< empty for a collection of images
    std::optional<Color> transparent;  ///< color key: pixels of this color become transparent
    int imageWidth = 0;                ///< px, according to the file
    int imageHeight = 0;
    std::vector<Tile> tiles;  ///< sorted by id; only tiles with data of their own
    Json properties = Json::object();
    Json wangSets = Json::array();  ///< kept as data; Wang ids have 8 colors: top, then clockwise
    Json notes = Json::object();    ///< data that only editors use: grid, transformations, terrains

    /// Returns the data of a tile; null if the file has none for it.
    [[nodiscard]] const Tile* find(int id) const;
};

enum class LayerKind : std::uint8_t { Tiles, Objects, Image };
enum class Orientation : std::uint8_t { Orthogonal, Isometric, Staggered, Hexagonal };
std::string_view nameOf(Orientation orientation);  ///< as in the files: "hexagonal"
std::optional<Orientation> orientationNamed(std::string_view name);

/// A layer; offset, opacity, tint, parallax and visibility include those of the groups that contain it.
struct Layer {
    LayerKind kind = LayerKind::Tiles;
    int id = 0;
    std::string name;
    std::string type;
    std::string group;  ///< path of the group that contains it: "outer/inner"; empty: none
    Vec2 offset;        ///< px
    double opacity = 1.0;
    Color tint;
    Vec2 parallax{1.0f, 1.0f};
    bool visible = true;
    bool locked = false;  ///< locked against editing in Tiled
    Json properties = Json::object();

    int x = 0;  ///< column of the first cell; chunks of infinite maps may begin below zero
    int y = 0;
    int width = 0;  ///< cells
    int height = 0;
    std::vector<Gid> cells;  ///< row by row from the top

    bool sortByY = true;  ///< objects are drawn in the order of y, not of the file
    std::string color;    ///< color of object shapes in Tiled; kept as data
    std::string blend;    ///< blend mode; empty: normal
    std::vector<Object> objects;

    std::string image;                 ///< relative to the map's folder
    std::optional<Color> transparent;  ///< color key: pixels of this color become transparent
    bool repeatX = false;
    bool repeatY = false;
};

/// Data of a layer group that its layers do not inherit; Layer::group refers to the group by its path.
struct Group {
    std::string path;
    int id = 0;
    std::string type;
    Json properties = Json::object();
};

struct Map {
    std::string version;
    std::string type;
    Orientation orientation = Orientation::Orthogonal;
    int hexSide = 0;         ///< px: the edge of a hexagon along the stagger axis
    bool staggersX = false;  ///< stagger axis of staggered and hexagonal maps: every other column is shifted
    bool staggersEven = false;  ///< the shifted columns or rows are the even ones
    std::string renderOrder = "right-down";
    bool infinite = false;
    int width = 0;  ///< cells
    int height = 0;
    int tileWidth = 0;  ///< px; in the orthogonal form of another map: its lattice's cell
    int tileHeight = 0;
    int wholeWidth = 0;  ///< px: the tile size of the map that this is the orthogonal form of; 0: of none
    int wholeHeight = 0;
    Vec2 parallaxOrigin;  ///< px
    std::optional<Color> background;
    Path folder;
    std::vector<Tileset> tilesets;  ///< tilesets used only by templates come last, with firstGid 0
    std::vector<Layer> layers;      ///< in drawing order
    std::vector<Group> groups;
    Json properties = Json::object();
    std::set<std::string> editorKeys;  ///< keys in the files that only Tiled uses; not imported

    /// True for the form of an isometric, staggered or hexagonal map in which its tiles lie in a finer grid.
    [[nodiscard]] bool isLattice() const { return wholeWidth > 0; }
    /// Returns the tile of a cell; empty for 0 and for ids that are in no tileset.
    [[nodiscard]] TileRef resolve(Gid gid) const;
};

}  // namespace plumb::tiled
