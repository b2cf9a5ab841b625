#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

/// A map of the Tiled editor as its files say it, before it becomes a scene. Units are px, degrees and ms, as
/// in the files.
namespace plumb::tiled {

/// A cell: the number of a tile over all tilesets of a map, 0 for none, and four bits that say how it is
/// turned.
using Gid = std::uint32_t;

inline constexpr Gid kFlipX = 0x80000000u;
inline constexpr Gid kFlipY = 0x40000000u;
inline constexpr Gid kFlipDiagonal = 0x20000000u;
inline constexpr Gid kRotateHex = 0x10000000u;  ///< only hexagonal maps mean something by it
inline constexpr Gid kFlags = kFlipX | kFlipY | kFlipDiagonal | kRotateHex;

/// A tile of one tileset, or none.
struct TileRef {
    int tileset = -1;  ///< place in Map::tilesets
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
    double x = 0.0;  ///< px; the origin about which it turns
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
    double rotation = 0.0;  ///< degrees, clockwise
    double opacity = 1.0;
    bool visible = true;
    TileRef tile;              ///< of Shape::Tile
    std::vector<Vec2> points;  ///< px from (x, y), of polygons and polylines
    TextStyle text;
    std::string templateFile;  ///< as the map names it; empty for none
    Json properties = Json::object();
};

struct Frame {
    int tile = 0;
    int milliseconds = 0;
};

/// What a tileset says about one of its tiles.
struct Tile {
    int id = 0;
    std::string type;
    std::string image;           ///< of its own, relative to the tileset's folder; empty for none
    std::optional<Rect> source;  ///< px in the image, when it is a part
    std::optional<Color> transparent;
    int width = 0;  ///< px of the image, as the file says; 0 when it does not
    int height = 0;
    double probability = 1.0;
    std::vector<Frame> animation;
    std::vector<Object> collision;
    Json properties = Json::object();
    std::string terrain;  ///< of the terrains before Tiled 1.5; kept as data
};

struct Tileset {
    Gid firstGid = 1;
    std::string name;
    std::string type;
    Path folder;  ///< to which its images are relative
    Path file;    ///< of an external one; empty when embedded
    bool missing = false;
    int tileWidth = 0;  ///< px
    int tileHeight = 0;
    int spacing = 0;
    int margin = 0;
    int count = 0;    ///< 0 when the file does not say
    int columns = 0;  ///< 0 when the file does not say
    int offsetX = 0;  ///< px
    int offsetY = 0;
    std::string objectAlignment;  ///< empty is bottom-left
    bool fitsGrid = false;        ///< tiles are stretched to the cell
    bool keepsAspect = false;     ///< … without changing their proportions
    std::string image;            ///< empty for a collection of images
    std::optional<Color> transparent;
    int imageWidth = 0;  ///< px, as the file says
    int imageHeight = 0;
    std::vector<Tile> tiles;  ///< by id
    Json properties = Json::object();
    Json wangSets = Json::array();  ///< kept as data; ids in the order top, clockwise, top-left
    Json notes = Json::object();    ///< what only editors use: grid, transformations, terrains

    /// What the file says about a tile; null when nothing.
    [[nodiscard]] const Tile* find(int id) const;
};

enum class LayerKind : std::uint8_t { Tiles, Objects, Image };
enum class Orientation : std::uint8_t { Orthogonal, Isometric };

/// A layer with everything that its groups add already in it.
struct Layer {
    LayerKind kind = LayerKind::Tiles;
    int id = 0;
    std::string name;
    std::string type;
    std::string group;  ///< names of the groups around it, outermost first, with '/'; empty for none
    Vec2 offset;        ///< px
    double opacity = 1.0;
    Color tint;
    Vec2 parallax{1.0f, 1.0f};
    bool visible = true;
    bool locked = false;
    Json properties = Json::object();

    int x = 0;  ///< cells, of the first cell; chunks may begin below zero
    int y = 0;
    int width = 0;  ///< cells
    int height = 0;
    std::vector<Gid> cells;  ///< in rows from the top

    bool sortByY = true;  ///< objects are drawn by their y, not in their order
    std::string color;    ///< of the shapes of objects, as the file says; kept as data
    std::string blend;    ///< empty is the usual one
    std::vector<Object> objects;

    std::string image;  ///< relative to the map's folder
    std::optional<Color> transparent;
    bool repeatX = false;
    bool repeatY = false;
};

/// A group, for what only it carries; its layers know its name.
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
    std::string renderOrder = "right-down";
    bool infinite = false;
    int width = 0;  ///< cells
    int height = 0;
    int tileWidth = 0;  ///< px
    int tileHeight = 0;
    Vec2 parallaxOrigin;  ///< px
    std::optional<Color> background;
    Path folder;
    std::vector<Tileset> tilesets;  ///< those that only templates use come last, with firstGid 0
    std::vector<Layer> layers;      ///< in the order of drawing
    std::vector<Group> groups;
    Json properties = Json::object();
    std::set<std::string> idle;  ///< names of what the files say and only Tiled needs; left out

    /// The tile that a cell names; empty for 0 and for numbers that no tileset has.
    [[nodiscard]] TileRef resolve(Gid gid) const;
};

}  // namespace plumb::tiled
