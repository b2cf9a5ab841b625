#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "assets/tileset.hpp"
#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr int kMaxSide = 4096;  // maximum side of a tile, px
constexpr float kMaxPixels = 16384.0f;
/// Reads a pair of integers; reports values out of range and returns the fallback for both.
std::pair<int, int> readPair(JsonFields& fields, std::string_view key, int min, int max, int fallback) {
    const auto kept = static_cast<float>(fallback);
    const Vec2 pair = fields.vec2(key, {kept, kept});
    const auto low = static_cast<float>(min);
    const auto high = static_cast<float>(max);
    if (pair.x >= low && pair.x <= high && pair.y >= low && pair.y <= high) {
        return {static_cast<int>(pair.x), static_cast<int>(pair.y)};
    }
    fields.warn(key, format("expected two numbers from {} to {}", min, max), "correct the numbers");
    return {fallback, fallback};
}

std::optional<std::vector<Vec2>> readPolygon(const Json& json) {
    std::vector<Vec2> points;
    bool good = json.is_array() && json.size() >= 3;
    for (const Json& point : json) {
        good = good && point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number();
        if (!good) break;
        const auto x = point[0].get<double>();
        const auto y = point[1].get<double>();
        good = x >= -kMaxSide && x <= kMaxSide && y >= -kMaxSide && y <= kMaxSide;
        if (good) points.push_back({static_cast<float>(x), static_cast<float>(y)});
    }
    return good ? std::optional{points} : std::nullopt;
}

/// Reads a polygon, or a list of polygons.
std::vector<std::vector<Vec2>> readPolygons(JsonFields& fields, const Json& json) {
    const bool isList = !json.empty() && json[0].is_array() && !json[0].empty() && json[0][0].is_array();
    std::vector<std::vector<Vec2>> polygons;
    std::size_t corners = 0;
    bool good = true;
    for (std::size_t i = 0; good && i < (isList ? json.size() : 1); ++i) {
        std::optional<std::vector<Vec2>> polygon = readPolygon(isList ? json[i] : json);
        corners += polygon ? polygon->size() : 0;
        good = polygon && corners <= Tile::kMaxCorners;
        if (good) polygons.push_back(std::move(*polygon));
    }
    if (good) return polygons;
    fields.warn("collision",
                format("expected polygons of 3 or more points, at most {} in all", Tile::kMaxCorners),
                "write [[x, y], [x, y], [x, y]] in px of the tile, or a list of such polygons");
    return {};
}

void readCollision(JsonFields& fields, Tile& tile) {
    const Json* json = fields.find("collision");
    if (json != nullptr && json->is_array()) {
        tile.polygons = readPolygons(fields, *json);
        tile.shape = tile.polygons.empty() ? TileShape::None : TileShape::Polygon;
    } else {
        tile.shape = static_cast<TileShape>(fields.choice("collision", 0, tileShapeNames()));
    }
}

Tile readTile(JsonFields& fields) {
    Tile tile;
    tile.id = fields.whole("id", -1, 0, Tileset::kMaxTiles - 1);
    readCollision(fields, tile);
    tile.oneWay = fields.flag("oneWay", false);
    tile.friction = fields.number("friction", -1.0f, 0.0f, 10.0f);
    tile.bounciness = fields.number("bounciness", -1.0f, 0.0f, 1.0f);
    tile.probability = fields.number("probability", 1.0f, 0.0f, 1e6f);
    tile.material = fields.text("material");
    for (JsonFields& item : fields.objects("animation", 1024)) {
        TileFrame frame;
        frame.tile = item.whole("tile", 0, 0, Tileset::kMaxTiles - 1);
        frame.seconds = item.number("seconds", 0.1f, 0.001f, 3600.0f);
        item.warnUnknown();
        tile.animation.push_back(frame);
    }
    tile.properties = fields.kept("properties");
    tile.unknown = fields.keepUnknown();
    return tile;
}

std::string hexOf(Color color) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t part : {color.r, color.g, color.b}) {
        text += kDigits[part >> 4];
        text += kDigits[part & 15];
    }
    return text;
}

Color readColor(JsonFields& fields, Color fallback) {
    const std::string text = fields.text("color", hexOf(fallback));
    const bool formed = text.size() == 7 && text.front() == '#';
    const std::optional<std::uint64_t> bits =
        formed ? parseHex(std::string_view{text}.substr(1)) : std::nullopt;
    if (!bits) {
        fields.warn("color", format("expected a color, found \"{}\"", text), "write \"#rrggbb\"");
        return fallback;
    }
    const auto part = [&](int shift) { return static_cast<std::uint8_t>(*bits >> shift); };
    return {part(16), part(8), part(0), 255};
}

Terrain readTerrain(JsonFields& fields) {
    Terrain terrain;
    terrain.id = fields.whole("id", -1, 1, 255);
    terrain.name = fields.text("name");
    terrain.mode = static_cast<TerrainMode>(fields.choice("mode", 1, terrainModeNames()));
    terrain.color = readColor(fields, terrain.color);
    for (JsonFields& item : fields.objects("tiles", Tileset::kMaxTiles)) {
        TerrainTile tile;
        tile.tile = item.whole("tile", 0, 0, Tileset::kMaxTiles - 1);
        tile.mask = static_cast<std::uint8_t>(item.whole("mask", 0, 0, 255));
        item.warnUnknown();
        terrain.tiles.push_back(tile);
    }
    fields.warnUnknown();
    return terrain;
}

TileImage readImage(JsonFields& fields) {
    TileImage image;
    image.tile = fields.whole("tile", -1, 0, Tileset::kMaxTiles - 1);
    image.path = fields.text("image");
    image.texture = {textId(image.path)};
    if (const Json* source = fields.array("source"); source != nullptr) {
        float numbers[4] = {};
        bool good = source->size() == 4;
        for (std::size_t i = 0; good && i < 4; ++i) {
            const double value = (*source)[i].is_number() ? (*source)[i].get<double>() : -1.0;
            good = value >= 0.0 && value <= static_cast<double>(kMaxPixels);
            if (good) numbers[i] = static_cast<float>(value);
        }
        if (good) {
            image.source = {numbers[0], numbers[1], numbers[2], numbers[3]};
        } else {
            fields.warn("source", "expected four numbers", "write [x, y, width, height] in px");
        }
    }
    fields.warnUnknown();
    return image;
}

/// Sorts items by id and removes those without an id (-1) or with the same id as another; reports duplicates.
template <class Item>
void settle(std::vector<Item>& items, int Item::*number, JsonFields& fields, std::string_view key) {
    const auto unnumbered = [&](const Item& item) { return item.*number < 0; };
    items.erase(std::remove_if(items.begin(), items.end(), unnumbered), items.end());
    std::stable_sort(items.begin(), items.end(),
                     [&](const Item& a, const Item& b) { return a.*number < b.*number; });
    const auto repeated = std::unique(items.begin(), items.end(),
                                      [&](const Item& a, const Item& b) { return a.*number == b.*number; });
    if (repeated != items.end())
        fields.warn(key, "there are two entries with the same id",
                    "remove one of them; the first one is used");
    items.erase(repeated, items.end());
}

/// Reads the sizes of an image that has grown. They must increase; the last one must match the tile count.
void readSizes(JsonFields& fields, Tileset& tileset) {
    std::int64_t cells = 0;
    for (JsonFields& item : fields.objects("sizes", 1024)) {
        const TilesetSize size{item.whole("columns", 0, 0, Tileset::kMaxTiles),
                               item.whole("rows", 0, 0, Tileset::kMaxTiles)};
        item.warnUnknown();
        const TilesetSize last =
            tileset.sizes.empty() ? TilesetSize{tileset.columns, 0} : tileset.sizes.back();
        const bool grows = size.columns >= last.columns && size.rows >= last.rows;
        const bool begins = !tileset.sizes.empty() || size.columns == tileset.columns;
        cells = std::int64_t{size.columns} * size.rows;
        if (grows && begins && cells <= tileset.count) {
            tileset.sizes.push_back(size);
            continue;
        }
        fields.warn("sizes", "the sizes must increase, begin with \"columns\" and end with \"count\" tiles",
                    "make \"sizes\", \"columns\" and \"count\" consistent");
        tileset.sizes.clear();
        return;
    }
    if (cells == 0 || cells == tileset.count) return;
    fields.warn("sizes", format("the last size has {} tiles, but \"count\" is {}", cells, tileset.count),
                "make \"sizes\" and \"count\" consistent");
    tileset.sizes.clear();
}

void readGrid(JsonFields& fields, Tileset& tileset) {
    tileset.image = fields.text("image");
    tileset.texture = {textId(tileset.image)};
    std::tie(tileset.tileWidth, tileset.tileHeight) = readPair(fields, "tileSize", 1, kMaxSide, 16);
    tileset.margin = fields.whole("margin", 0, 0, kMaxSide);
    tileset.spacing = fields.whole("spacing", 0, 0, kMaxSide);
    tileset.columns = fields.whole("columns", 1, 1, Tileset::kMaxTiles);
    tileset.count = fields.whole("count", 0, 0, Tileset::kMaxTiles);
    tileset.offset = fields.vec2("offset", {});
    readSizes(fields, tileset);
}

Json pointJson(Vec2 point) { return Json::array({point.x, point.y}); }

Json tileJson(const Tile& tile) {
    Json json = Json::object();
    json["id"] = tile.id;
    if (tile.shape == TileShape::Polygon) {
        Json all = Json::array();
        for (const std::vector<Vec2>& polygon : tile.polygons) {
            Json& points = all.emplace_back(Json::array());
            for (const Vec2 point : polygon) points.push_back(pointJson(point));
        }
        json["collision"] = all.size() == 1 ? all.front() : all;
    } else if (tile.shape != TileShape::None) {
        json["collision"] = std::string{tileShapeNames()[static_cast<std::size_t>(tile.shape)]};
    }
    if (tile.oneWay) json["oneWay"] = true;
    if (tile.friction >= 0.0f) json["friction"] = tile.friction;
    if (tile.bounciness >= 0.0f) json["bounciness"] = tile.bounciness;
    if (tile.probability != 1.0f) json["probability"] = tile.probability;
    if (!tile.material.empty()) json["material"] = tile.material;
    for (const TileFrame& frame : tile.animation) {
        Json item = Json::object();
        item["tile"] = frame.tile;
        item["seconds"] = frame.seconds;
        json["animation"].push_back(std::move(item));
    }
    if (!tile.properties.empty()) writeKept(json["properties"], tile.properties);
    writeKept(json, tile.unknown);
    return json;
}

Json terrainJson(const Terrain& terrain) {
    Json json = Json::object();
    json["id"] = terrain.id;
    json["name"] = terrain.name;
    json["mode"] = std::string{terrainModeNames()[static_cast<std::size_t>(terrain.mode)]};
    json["color"] = hexOf(terrain.color);
    for (const TerrainTile& tile : terrain.tiles) {
        Json item = Json::object();
        item["tile"] = tile.tile;
        item["mask"] = tile.mask;
        json["tiles"].push_back(std::move(item));
    }
    return json;
}

Json imageJson(const TileImage& image) {
    Json json = Json::object();
    json["tile"] = image.tile;
    json["image"] = image.path;
    if (!image.source.empty()) {
        json["source"] =
            Json::array({image.source.x, image.source.y, image.source.width, image.source.height});
    }
    return json;
}

}  // namespace

Result<Tileset> parseTileset(std::string_view text, std::string_view where, std::vector<Error>& problems) {
    const Result<Json> json = parseJson(text, where, &problems);
    if (!json) return json.error();
    if (!json->is_object()) {
        return Error{std::string{where}, "expected an object, found " + briefText(*json), "write { ... }"};
    }
    JsonFields fields{*json, std::string{where}, problems};
    if (!fields.acceptFormat(Tileset::kFormat)) {
        Error error = std::move(problems.back());
        problems.pop_back();
        return error;
    }
    Tileset tileset;
    readGrid(fields, tileset);
    for (JsonFields& item : fields.objects("images", Tileset::kMaxTiles))
        tileset.images.push_back(readImage(item));
    for (JsonFields& item : fields.objects("tiles", Tileset::kMaxTiles))
        tileset.tiles.push_back(readTile(item));
    settle(tileset.images, &TileImage::tile, fields, "images");
    settle(tileset.tiles, &Tile::id, fields, "tiles");
    for (JsonFields& item : fields.objects("terrains", 255)) tileset.terrains.push_back(readTerrain(item));
    settle(tileset.terrains, &Terrain::id, fields, "terrains");
    tileset.properties = fields.kept("properties");
    tileset.unknown = fields.keepUnknown();
    return tileset;
}

std::string writeTileset(const Tileset& tileset) {
    Json json = Json::object();
    json["format"] = Tileset::kFormat;
    if (!tileset.image.empty()) json["image"] = tileset.image;
    json["tileSize"] = Json::array({tileset.tileWidth, tileset.tileHeight});
    json["margin"] = tileset.margin;
    json["spacing"] = tileset.spacing;
    json["columns"] = tileset.columns;
    json["count"] = tileset.count;
    for (const TilesetSize& size : tileset.sizes) {
        Json item = Json::object();
        item["columns"] = size.columns;
        item["rows"] = size.rows;
        json["sizes"].push_back(std::move(item));
    }
    for (const TileImage& image : tileset.images) json["images"].push_back(imageJson(image));
    if (tileset.offset != Vec2{}) json["offset"] = pointJson(tileset.offset);
    for (const Tile& tile : tileset.tiles) json["tiles"].push_back(tileJson(tile));
    for (const Terrain& terrain : tileset.terrains) json["terrains"].push_back(terrainJson(terrain));
    if (!tileset.properties.empty()) writeKept(json["properties"], tileset.properties);
    writeKept(json, tileset.unknown);
    return writeCompactJson(json);
}

}  // namespace plumb
