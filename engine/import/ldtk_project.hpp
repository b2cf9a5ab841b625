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

/// An LDtk project as read from its files, before conversion to scenes. Units are px, as in the files.
namespace plumb::ldtk {

/// A region of a tileset's image.
struct TileRect {
    int tileset = -1;  ///< uid of the tileset
    Rect area;         ///< px
};

struct Tileset {
    int uid = 0;
    std::string name;
    std::string image;   ///< path relative to the project's folder; empty: LDtk's built-in icons
    int imageWidth = 0;  ///< px
    int imageHeight = 0;
    int grid = 16;                ///< tile size, px
    int spacing = 0;              ///< px between tiles
    int padding = 0;              ///< px between the image's edge and the tiles
    Json notes = Json::object();  ///< tags, enum tags and custom data of tiles, unchanged JSON

    [[nodiscard]] int columns() const;
    [[nodiscard]] int rows() const;
    /// Returns the region of a tile in the image, px.
    [[nodiscard]] Rect sourceOf(int tile) const;
    /// Returns the tile whose upper left corner is at (x, y), px; -1 if there is none.
    [[nodiscard]] int tileAt(int x, int y) const;
};

struct IntGridValue {
    int value = 0;
    std::string name;  ///< may be empty
    Color color;
};

/// An LDtk layer definition, shared by its layers in all levels.
struct LayerKind {
    int uid = 0;
    Vec2 parallax;  ///< ratio; 0: fixed to the world
    bool scalesWithParallax = false;
    int ruleGroups = 0;  ///< number of groups of auto-layer rules
    int source = -1;     ///< uid of the IntGrid layer that is the input of the auto-layer rules; -1: none
    std::vector<IntGridValue> values;
};

/// Modes in which an entity's image fills its box. None: not stated in the file; Plain: own size, unclipped.
enum class Fill : std::uint8_t { None, Stretch, FitInside, Cover, Plain, Repeat, NineSlice };

struct EntityKind {
    int uid = 0;
    std::string name;
    std::string drawnAs;  ///< "Tile", "Rectangle", "Ellipse" or "Cross"
    Fill fill = Fill::None;
    double opacity = 1.0;  ///< opacity of the image, 0 to 1
    bool resizable = false;
    Color color;
};

struct Field {
    std::string name;
    std::string type;  ///< "Int", "Array<LocalEnum.Item>", …
    Json value;        ///< unchanged JSON; null if not set
};

/// A tile placed in a layer.
struct Tile {
    int x = 0;  ///< top left corner, px in the layer
    int y = 0;
    int tile = 0;
    int sourceX = -1;  ///< upper left corner in the tileset's image, px; -1 if not in the file
    int sourceY = -1;
    std::uint8_t flips = 0;  ///< bit 0: horizontal flip, bit 1: vertical flip
    float opacity = 1.0f;
};

struct Entity {
    std::string name;
    std::string iid;
    int kind = 0;   ///< uid of the entity definition
    Vec2 position;  ///< position of the pivot, px in the layer
    Vec2 pivot;     ///< ratio of the size
    int width = 0;  ///< px
    int height = 0;
    std::optional<TileRect> tile;
    Color color;
    std::vector<std::string> tags;
    std::vector<Field> fields;
};

struct Layer {
    std::string name;
    std::string type;  ///< "IntGrid", "AutoLayer", "Tiles" or "Entities"
    std::string iid;
    int kind = 0;  ///< uid of the layer definition
    int columns = 0;
    int rows = 0;
    int grid = 16;  ///< cell size, px
    Vec2 offset;    ///< px
    double opacity = 1.0;
    bool visible = true;
    int tileset = -1;         ///< uid of the tileset
    std::vector<int> values;  ///< IntGrid values, row by row; 0: empty; missing ones at the end are 0
    std::vector<Tile> tiles;  ///< in drawing order: tiles placed by rules, then those placed by hand
    std::vector<Entity> entities;

    [[nodiscard]] std::size_t cellCount() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
};

struct Level {
    std::string name;
    std::string iid;
    Vec2 position;  ///< px in its world
    int depth = 0;  ///< LDtk's world depth: levels of different depth may overlap
    int width = 0;  ///< px
    int height = 0;
    Color color;        ///< background color
    std::string image;  ///< path of the background image; empty: none
    Vec2 imageTopLeft;  ///< px in the level
    Vec2 imageScale{1.0f, 1.0f};
    Rect imageCrop;  ///< visible region of the image, px
    std::vector<Field> fields;
    std::vector<Layer> layers;  ///< topmost first, as in the file
};

struct World {
    std::string name;
    std::string iid;
    std::string layout;  ///< "Free", "GridVania", "LinearHorizontal" or "LinearVertical"
    std::vector<Level> levels;
};

struct Project {
    std::string version;
    Path folder;
    std::vector<Tileset> tilesets;
    std::vector<LayerKind> layers;
    std::vector<EntityKind> entities;
    Json enums = Json::array();     ///< enum definitions, unchanged JSON
    Json contents = Json::array();  ///< table of contents, unchanged JSON
    std::vector<World> worlds;
    std::set<std::string> editorKeys;  ///< keys in the file that only LDtk uses; not imported

    [[nodiscard]] const Tileset* tileset(int uid) const;
    [[nodiscard]] const LayerKind* layerKind(int uid) const;
    [[nodiscard]] const EntityKind* entityKind(int uid) const;
};

}  // namespace plumb::ldtk
