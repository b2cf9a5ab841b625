#include "import/import_tilesets.hpp"

#include <algorithm>

#include "assets/tileset.hpp"
#include "core/text.hpp"
#include "import/import_terrains.hpp"
#include "import/tile_shapes.hpp"
#include "import/tiled_json.hpp"
#include "physics/terrain/tile_mask.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

struct Grid {
    int columns = 1;
    int count = 0;
};

/// Returns the number of complete tiles in an image's width or height, with Tiled's formula.
int tilesAlong(int pixels, int tile, int margin, int spacing) {
    return tile > 0 ? std::max((pixels - margin + spacing) / (tile + spacing), 0) : 0;
}

Grid gridOf(const tiled::Tileset& tileset, const StagedImage& image) {
    const int width = image.width > 0 ? image.width : tileset.imageWidth;
    const int height = image.height > 0 ? image.height : tileset.imageHeight;
    Grid grid;
    grid.columns = tilesAlong(width, tileset.tileWidth, tileset.margin, tileset.spacing);
    if (grid.columns == 0) grid.columns = std::max(tileset.columns, 1);
    grid.count = grid.columns * tilesAlong(height, tileset.tileHeight, tileset.margin, tileset.spacing);
    if (grid.count == 0) grid.count = tileset.count;
    grid.count = std::min(grid.count, Tileset::kMaxTiles);
    return grid;
}

Rect cellOfImage(const tiled::Tileset& tileset, const Grid& grid, int id) {
    const int column = id % grid.columns;
    const int row = id / grid.columns;
    return {static_cast<float>(tileset.margin + column * (tileset.tileWidth + tileset.spacing)),
            static_cast<float>(tileset.margin + row * (tileset.tileHeight + tileset.spacing)),
            static_cast<float>(tileset.tileWidth), static_cast<float>(tileset.tileHeight)};
}

TileRegion pictureOfCollection(const tiled::Tileset& tileset, const tiled::Tile& tile, ImportStage& stage) {
    const StagedImage& image = stage.image(tileset.folder / tile.image, tile.transparent);
    const auto width = static_cast<float>(image.width > 0 ? image.width : tile.width);
    const auto height = static_cast<float>(image.height > 0 ? image.height : tile.height);
    return {image.path, tile.source.value_or(Rect{0.0f, 0.0f, width, height})};
}

/// The tileset that is imported, and the map whose grid it is made for.
struct TilesetImport {
    const tiled::Map& map;
    const tiled::Tileset& tileset;
    ImportStage& stage;
    Vec2 cell;  ///< px of the tileset's image

    void tell(const tiled::Tile& tile, std::string what) const {
        stage.problems.push_back(
            {format("tileset {}: tile {}", tileset.name, tile.id), std::move(what),
             "the shapes are kept under \"tiled\"; draw fewer or simpler ones in Tiled"});
    }
    void tell(const tiled::Tile& tile, const ShapeRefusal& refusal) const {
        stage.problems.push_back(
            {format("tileset {}: tile {}: {} {}", tileset.name, tile.id, nameOf(refusal.shape->shape),
                    refusal.shape->id),
             "the collision shape is not as in Tiled: " + refusal.what,
             "the shape is kept under \"tiled\"; draw an area or a line inside the tile"});
    }
};

/// Reports collision shapes of which addTileColliders will make no collider.
void tellUnsolid(const TilesetImport& import, const tiled::Tile& tile, Vec2 tileSize) {
    std::vector<ShapeRefusal> refusals;
    static_cast<void>(collisionLinesOf(tile, import.tileset, tileSize.y, &refusals));
    for (const ShapeRefusal& refusal : refusals) import.tell(tile, refusal);
}

/// Returns the form that a tile has in a terrain. @error it cannot be made
Result<physics::TileForm> formOf(std::vector<std::vector<Vec2>> polygons, Vec2 cell) {
    for (std::vector<Vec2>& polygon : polygons) {
        for (Vec2& corner : polygon) corner = {corner.x / cell.x, corner.y / cell.y};
    }
    return physics::TilePalette{}.addPolygons(polygons);
}

/// Converts the collision shapes of a tile to polygons; reports shapes that they do not cover.
void addCollision(Json& json, const TilesetImport& import, const tiled::Tile& tile, Vec2 tileSize) {
    Json shapes = Json::array();
    for (const tiled::Object& object : tile.collision) {
        shapes.push_back(objectJson(object));
        if (!object.properties.empty()) shapes.back()["properties"] = object.properties;
    }
    json["tiled"]["collision"] = std::move(shapes);
    if (import.map.isLattice()) return tellUnsolid(import, tile, tileSize);

    // The tile is aligned to the lower left corner of its cell.
    const TileArea area = areaOfTile(tile, import.cell, import.cell.y - tileSize.y);
    for (const ShapeRefusal& refusal : area.refusals) import.tell(tile, refusal);
    if (area.polygons.empty()) return;
    const Result<physics::TileForm> form = formOf(area.polygons, import.cell);
    if (!form) {
        import.tell(tile, form.error().what + "; the tile collides as a full cell");
    }
    if (!form || *form == physics::TileForm::Full) {
        json["collision"] = "full";
        return;
    }
    Json polygons = Json::array();
    for (const std::vector<Vec2>& polygon : area.polygons) {
        Json& corners = polygons.emplace_back(Json::array());
        for (const Vec2 corner : polygon) corners.push_back(vec2Json(corner));
    }
    json["collision"] = polygons.size() == 1 ? polygons.front() : polygons;
}

/// Reports a tile id or animation frames beyond the end of the tileset.
/// @param count  number of tiles in the tileset; 0 if unknown because its image is missing
void tellBeyond(const tiled::Tile& tile, int count, ImportStage& stage, const tiled::Tileset& tileset) {
    if (count == 0) return;
    const auto beyond = std::count_if(tile.animation.begin(), tile.animation.end(),
                                      [count](const tiled::Frame& frame) { return frame.tile >= count; });
    if (beyond == 0 && tile.id < count) return;
    stage.problems.push_back(
        {format("tileset {}: tile {}", tileset.name, tile.id),
         tile.id >= count
             ? format("the tile id is beyond the {} tiles of the image", count)
             : format("{} frames of the animation are beyond the {} tiles of the image", beyond, count),
         "check the tileset's image, margin and spacing in Tiled"});
}

Json tileJson(const TilesetImport& import, const tiled::Tile& tile, Vec2 tileSize) {
    Json json = Json::object();
    json["id"] = tile.id;
    if (!tile.collision.empty()) addCollision(json, import, tile, tileSize);
    for (const tiled::Frame& frame : tile.animation) {
        Json item = Json::object();
        item["tile"] = frame.tile;
        item["seconds"] = static_cast<float>(std::max(frame.milliseconds, 1)) / 1000.0f;
        json["animation"].push_back(std::move(item));
    }
    if (!tile.properties.empty()) json["properties"] = tile.properties;
    if (!tile.type.empty()) json["tiled"]["type"] = tile.type;
    if (tile.probability != 1.0) json["probability"] = static_cast<float>(tile.probability);
    if (!tile.terrain.empty()) json["tiled"]["terrain"] = tile.terrain;
    return json;
}

Json tilesetNotes(const tiled::Tileset& tileset) {
    Json notes = Json::object();
    notes["name"] = tileset.name;
    if (!tileset.type.empty()) notes["type"] = tileset.type;
    if (!tileset.objectAlignment.empty()) notes["objectAlignment"] = tileset.objectAlignment;
    if (tileset.keepsAspect) notes["fillMode"] = "preserve-aspect-fit";
    if (!tileset.wangSets.empty()) notes["wangSets"] = tileset.wangSets;
    for (const auto& [key, value] : tileset.notes.items()) notes[key] = value;
    return notes;
}

Json imageJson(int tile, const TileRegion& picture) {
    Json json = Json::object();
    json["tile"] = tile;
    json["image"] = picture.texture;
    const Rect& source = picture.source;
    if (!source.empty()) json["source"] = Json::array({source.x, source.y, source.width, source.height});
    return json;
}

void addPictures(Json& json, const tiled::Tileset& tileset, ImportedTileset& imported, bool loose,
                 ImportStage& stage) {
    if (tileset.image.empty()) {
        for (const tiled::Tile& tile : tileset.tiles) imported.count = std::max(imported.count, tile.id + 1);
        imported.count = std::min(imported.count, Tileset::kMaxTiles);
        for (const tiled::Tile& tile : tileset.tiles) {
            if (tile.id >= imported.count || tile.image.empty()) continue;
            const TileRegion& picture = imported.pictures[tile.id] =
                pictureOfCollection(tileset, tile, stage);
            json["images"].push_back(imageJson(tile.id, picture));
        }
        json["columns"] = 1;
    } else {
        imported.image = stage.image(tileset.folder / tileset.image, tileset.transparent);
        const Grid grid = gridOf(tileset, imported.image);
        imported.count = grid.count;
        if (!loose) {
            json["image"] = imported.image.path;
            if (tileset.margin > 0) json["margin"] = tileset.margin;
            if (tileset.spacing > 0) json["spacing"] = tileset.spacing;
        }
        if (loose && grid.count > kMaxLooseTiles) {
            imported.count = kMaxLooseTiles;
            stage.problems.push_back(
                {format("tileset {}", tileset.name),
                 format("{} tiles differ in size from the map's cells; only the first {} were imported",
                        grid.count, imported.count),
                 "make the map's cells as large as these tiles, or split the tileset"});
        }
        for (int id = 0; loose && id < imported.count; ++id) {
            json["images"].push_back(imageJson(id, {imported.image.path, cellOfImage(tileset, grid, id)}));
        }
        json["columns"] = grid.columns;
    }
    json["count"] = imported.count;
}

struct CellSize {
    int width = 1;
    int height = 1;
};

CellSize sizeOfTiles(const tiled::Tileset& tileset) {
    return {std::max(tileset.tileWidth, 1), std::max(tileset.tileHeight, 1)};
}

/// Returns the size of a cell in px of the image, with which tiles are drawn as large as the map's tiles.
CellSize cellOfStretched(const tiled::Map& map, const tiled::Tileset& tileset, ImportStage& stage) {
    CellSize size = sizeOfTiles(tileset);
    if (!map.isLattice()) return size;
    const int width = size.width * map.tileWidth;
    const int height = size.height * map.tileHeight;
    if (width % map.wholeWidth != 0 || height % map.wholeHeight != 0) {
        stage.problems.push_back(
            {format("tileset {}", tileset.name),
             format("tiles of {} x {} px cannot be stretched exactly to the map's {} x {} px", size.width,
                    size.height, map.wholeWidth, map.wholeHeight),
             "make the images of the tiles as large as the map's tiles"});
    }
    return {std::max(width / map.wholeWidth, 1), std::max(height / map.wholeHeight, 1)};
}

/// Reports tiles of a collection that Tiled stretches to the grid: only tiles of one size can be stretched.
void tellUnstretched(const tiled::Map& map, const tiled::Tileset& tileset, const ImportedTileset& imported,
                     ImportStage& stage) {
    const auto width = static_cast<float>(map.isLattice() ? map.wholeWidth : map.tileWidth);
    const auto height = static_cast<float>(map.isLattice() ? map.wholeHeight : map.tileHeight);
    const auto differs = [&](const auto& picture) {
        const Rect& source = picture.second.source;
        return source.width != width || source.height != height;
    };
    if (std::none_of(imported.pictures.begin(), imported.pictures.end(), differs)) return;
    stage.problems.push_back({format("tileset {}", tileset.name),
                              "tiles that are images of their own are not stretched to the grid",
                              "make the images as large as the map's tiles"});
}

}  // namespace

TileRegion ImportedTileset::pictureOf(int id) const {
    if (id < 0 || id >= count) return {};
    if (original->image.empty()) {
        const auto found = pictures.find(id);
        return found == pictures.end() ? TileRegion{} : found->second;
    }
    return {image.path, cellOfImage(*original, gridOf(*original, image), id)};
}

bool ImportedTileset::isDeleted(int id) const {
    return original->image.empty() && id >= 0 && id < count && !pictures.contains(id);
}

Vec2 ImportedTileset::sizeOf(int id) const {
    const Rect source = pictureOf(id).source;
    if (!source.empty()) return {source.width, source.height};
    return {static_cast<float>(std::max(original->tileWidth, 1)),
            static_cast<float>(std::max(original->tileHeight, 1))};
}

Vec2 ImportedTileset::scaleIn(const tiled::Map& map, int id) const {
    if (!original->fitsGrid || original->image.empty()) return {1.0f, 1.0f};
    const Vec2 size = sizeOf(id);
    const int width = map.isLattice() ? map.wholeWidth : map.tileWidth;
    const int height = map.isLattice() ? map.wholeHeight : map.tileHeight;
    return {static_cast<float>(width) / size.x, static_cast<float>(height) / size.y};
}

ImportedTileset importTileset(const tiled::Map& map, const tiled::Tileset& tileset, ImportStage& stage) {
    ImportedTileset imported;
    imported.original = &tileset;
    const bool sameSize = tileset.tileWidth == map.tileWidth && tileset.tileHeight == map.tileHeight;
    const bool stretched = tileset.fitsGrid && !tileset.image.empty();
    const bool loose = !stretched ? tileset.image.empty() || !sameSize : map.isLattice();
    const CellSize cellSize = stretched ? cellOfStretched(map, tileset, stage)
                              : loose   ? CellSize{map.tileWidth, map.tileHeight}
                                        : sizeOfTiles(tileset);

    Json json = Json::object();
    json["format"] = Tileset::kFormat;
    json["tileSize"] = Json::array({cellSize.width, cellSize.height});
    addPictures(json, tileset, imported, loose, stage);
    if (tileset.offsetX != 0 || tileset.offsetY != 0)
        json["offset"] = Json::array({tileset.offsetX, tileset.offsetY});
    if (tileset.fitsGrid && !stretched) tellUnstretched(map, tileset, imported, stage);
    const Vec2 cell{static_cast<float>(cellSize.width), static_cast<float>(cellSize.height)};
    const TilesetImport import{map, tileset, stage, cell};
    for (const tiled::Tile& tile : tileset.tiles) {
        const TileRegion picture = imported.pictureOf(tile.id);
        tellBeyond(tile, imported.count, stage, tileset);
        const Vec2 size = picture.source.empty() ? cell : Vec2{picture.source.width, picture.source.height};
        Json item = tileJson(import, tile, size);
        imported.collides = imported.collides || item.contains("collision");
        if (item.size() > 1) json["tiles"].push_back(std::move(item));
    }
    if (!tileset.properties.empty()) json["properties"] = tileset.properties;
    if (Json terrains = terrainsOf(tileset); !terrains.empty()) json["terrains"] = std::move(terrains);
    json["tiled"] = tilesetNotes(tileset);
    imported.path = stage.add(tileset.name, ".tileset.json", writeJson(json));
    return imported;
}

}  // namespace plumb
