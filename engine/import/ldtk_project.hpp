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

/// A project of the LDtk editor as its files say it, before it becomes scenes. Units are px, as in the files.
namespace plumb::ldtk {

/// A part of a tileset's picture.
struct TileRect {
    int tileset = -1;  ///< uid
    Rect area;         ///< px
};

struct Tileset {
    int uid = 0;
    std::string name;
    std::string image;   ///< relative to the project's folder; empty: LDtk's own icons
    int imageWidth = 0;  ///< px
    int imageHeight = 0;
    int grid = 16;                ///< px, of a tile
    int spacing = 0;              ///< px between tiles
    int padding = 0;              ///< px around all
    Json notes = Json::object();  ///< tags, enum tags and data of tiles, as they stand

    [[nodiscard]] int columns() const;
    [[nodiscard]] int rows() const;
    /// Where a tile is in the picture (px).
    [[nodiscard]] Rect sourceOf(int tile) const;
    /// The tile whose upper left corner is there (px); -1 when none is.
    [[nodiscard]] int tileAt(int x, int y) const;
};

struct IntGridValue {
    int value = 0;
    std::string name;  ///< empty when it has none
    Color color;
};

/// What all layers of one kind share.
struct LayerKind {
    int uid = 0;
    Vec2 parallax;  ///< ratio; 0 moves with the world
    bool scalesWithParallax = false;
    int ruleGroups = 0;
    int source = -1;  ///< uid of the layer of an IntGrid whose values its rules draw; -1 for none
    std::vector<IntGridValue> values;
};

/// How the picture of an entity fills its box.
enum class Fill : std::uint8_t { None, Stretch, FitInside, Cover, Plain, Repeat, NineSlice };

struct EntityKind {
    int uid = 0;
    std::string name;
    std::string drawnAs;  ///< "Tile", "Rectangle", "Ellipse" or "Cross"
    Fill fill = Fill::None;
    double opacity = 1.0;  ///< of the picture
    bool resizable = false;
    Color color;
};

struct Field {
    std::string name;
    std::string type;  ///< "Int", "Array<LocalEnum.Item>", …
    Json value;        ///< as it stands; null for none
};

/// A tile of a layer, in the order of drawing.
struct Tile {
    int x = 0;  ///< px in the layer, of the top-left corner
    int y = 0;
    int tile = 0;
    int sourceX = -1;  ///< px in the picture, of its upper left corner; -1 where the file does not say
    int sourceY = -1;
    std::uint8_t flips = 0;  ///< bit 0: left to right, bit 1: upside down
    float opacity = 1.0f;
};

struct Entity {
    std::string name;
    std::string iid;
    int kind = 0;   ///< uid
    Vec2 position;  ///< px in the layer, of the pivot
    Vec2 pivot;     ///< ratio
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
    int kind = 0;  ///< uid
    int columns = 0;
    int rows = 0;
    int grid = 16;  ///< px
    Vec2 offset;    ///< px
    double opacity = 1.0;
    bool visible = true;
    int tileset = -1;         ///< uid
    std::vector<int> values;  ///< of an IntGrid, in rows; 0 is empty, and so are those missing at the end
    std::vector<Tile> tiles;  ///< drawn by rules, then by hand
    std::vector<Entity> entities;

    [[nodiscard]] std::size_t cellCount() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
};

struct Level {
    std::string name;
    std::string iid;
    Vec2 position;  ///< px in its world
    int depth = 0;
    int width = 0;  ///< px
    int height = 0;
    Color color;
    std::string image;  ///< behind everything; empty for none
    Vec2 imageTopLeft;  ///< px in the level
    Vec2 imageScale{1.0f, 1.0f};
    Rect imageCrop;  ///< px of the picture
    std::vector<Field> fields;
    std::vector<Layer> layers;  ///< top first, as in the file
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
    Json enums = Json::array();     ///< as they stand
    Json contents = Json::array();  ///< the table of contents, as it stands
    std::vector<World> worlds;
    std::set<std::string> idle;  ///< names of what the file says and only LDtk needs; left out

    [[nodiscard]] const Tileset* tileset(int uid) const;
    [[nodiscard]] const LayerKind* layerKind(int uid) const;
    [[nodiscard]] const EntityKind* entityKind(int uid) const;
};

}  // namespace plumb::ldtk
