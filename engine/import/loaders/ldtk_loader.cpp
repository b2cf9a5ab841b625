#include "import/loaders/ldtk_loader.hpp"

#include <algorithm>
#include <array>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "import/loaders/ldtk_fields.hpp"
#include "import/loaders/ldtk_keys.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr float kBetweenLevels = 32.0f;  // px: gap between levels in linear layouts, as LDtk displays them
constexpr std::array<std::string_view, 7> kFills{
    "", "Stretch", "FitInside", "Cover", "FullSizeUncropped", "Repeat", "NineSlice"};

std::vector<ldtk::Field> readFields(const LdtkFields& owner) {
    std::vector<ldtk::Field> fields;
    for (const LdtkFields& from : owner.objects("fieldInstances")) {
        const Json* value = from.find("__value");
        fields.push_back(
            {from.text("__identifier"), from.text("__type"), value == nullptr ? Json{} : *value});
    }
    return fields;
}

/// True if an area can be a region of an image, so that its sides can be converted to int without overflow.
bool isPart(const Rect& area) {
    constexpr auto kSide = static_cast<float>(limits::kImageSide);
    return area.x >= 0.0f && area.y >= 0.0f && area.width >= 0.0f && area.height >= 0.0f && area.x <= kSide &&
           area.y <= kSide && area.width <= kSide && area.height <= kSide;
}

std::optional<ldtk::TileRect> readTileRect(const LdtkFields& from, std::string_view key) {
    const Json* json = from.find(key);
    if (json == nullptr || !json->is_object()) return {};
    const auto number = [&](const char* name) {
        const Json* found = findMember(*json, name);
        return found == nullptr ? 0.0f : floatOf(*found).value_or(0.0f);
    };
    const Json* uid = findMember(*json, "tilesetUid");
    const ldtk::TileRect tile{uid == nullptr ? 0 : intOf(*uid).value_or(0),
                              {number("x"), number("y"), number("w"), number("h")}};
    if (isPart(tile.area)) return tile;
    from.warn(key, "the tile's rectangle is negative or too large", "select the tile again in LDtk");
    return {};
}

ldtk::Entity readEntity(const LdtkFields& from) {
    ldtk::Entity entity;
    entity.name = from.text("__identifier");
    entity.iid = from.text("iid");
    entity.kind = from.whole("defUid", 0);
    entity.position = from.pair("px", {});
    entity.pivot = from.pair("__pivot", {});
    entity.width = from.whole("width", 16);
    entity.height = from.whole("height", 16);
    entity.tile = readTileRect(from, "__tile");
    entity.color = from.color("__smartColor", Color{});
    if (const Json* tags = from.find("__tags"); tags != nullptr && tags->is_array()) {
        for (const Json& tag : *tags) {
            if (const std::string* text = jsonText(tag)) entity.tags.push_back(*text);
        }
    }
    entity.fields = readFields(from);
    return entity;
}

void readTiles(const LdtkFields& from, std::string_view key, std::vector<ldtk::Tile>& tiles) {
    for (const LdtkFields& item : from.objects(key)) {
        ldtk::Tile tile;
        const Vec2 position = item.pair("px", {});
        tile.x = static_cast<int>(position.x);
        tile.y = static_cast<int>(position.y);
        tile.tile = item.whole("t", 0);
        const Vec2 source = item.pair("src", {-1.0f, -1.0f});
        tile.sourceX = static_cast<int>(source.x);
        tile.sourceY = static_cast<int>(source.y);
        tile.flips = static_cast<std::uint8_t>(item.whole("f", 0) & 3);
        tile.opacity = std::clamp(static_cast<float>(item.real("a", 1.0)), 0.0f, 1.0f);
        if (tile.tile >= 0) tiles.push_back(tile);
    }
}

/// Reads an IntGrid: an array of numbers, or an array of cells as written before LDtk 0.8.
void readValues(const LdtkFields& from, ldtk::Layer& layer) {
    const std::size_t count = layer.cellCount();
    if (const Json* csv = from.find("intGridCsv"); csv != nullptr && csv->is_array() && !csv->empty()) {
        for (const Json& value : *csv) layer.values.push_back(intOf(value).value_or(0));
        if (layer.values.size() != count)
            from.warn("intGridCsv",
                      format("found {} cells, expected {} for the layer's size", layer.values.size(), count),
                      "save the project again in LDtk");
        if (layer.values.size() > count) layer.values.resize(count);
    } else if (const Json* cells = from.find("intGrid"); cells != nullptr && !cells->empty()) {
        for (const LdtkFields& cell : from.objects("intGrid")) {
            const auto index = static_cast<std::size_t>(std::max(cell.whole("coordId", 0), 0));
            if (index >= count) continue;
            if (layer.values.size() <= index) layer.values.resize(index + 1);
            layer.values[index] = cell.whole("v", -1) + 1;
        }
    }
}

/// @param room  number of cells that further layers of the project may have; reduced by those of this layer
std::optional<ldtk::Layer> readLayer(const LdtkFields& from, std::size_t& room) {
    ldtk::Layer layer;
    layer.name = from.text("__identifier");
    layer.type = from.text("__type");
    layer.iid = from.text("iid");
    layer.kind = from.whole("layerDefUid", 0);
    layer.columns = from.whole("__cWid", 0);
    layer.rows = from.whole("__cHei", 0);
    layer.grid = from.whole("__gridSize", 16);
    const bool fits = layer.columns >= 0 && layer.columns <= limits::kTileSide && layer.rows >= 0 &&
                      layer.rows <= limits::kTileSide && layer.grid >= 1 && layer.grid <= limits::kImageSide;
    if (!fits) {
        from.warn("__cWid",
                  format("the layer's size of {} x {} cells of {} px is not supported", layer.columns,
                         layer.rows, layer.grid),
                  format("the maximum is {} cells per side", limits::kTileSide));
        return {};
    }
    if (layer.cellCount() > room) {
        from.warn("__cWid",
                  format("with its {} x {} cells, the layers of the project exceed {} cells", layer.columns,
                         layer.rows, limits::kTiledCells),
                  "split the project, or give the layer larger cells");
        return {};
    }
    room -= layer.cellCount();
    layer.offset = {static_cast<float>(from.real("__pxTotalOffsetX", 0.0)),
                    static_cast<float>(from.real("__pxTotalOffsetY", 0.0))};
    layer.opacity = std::clamp(from.real("__opacity", 1.0), 0.0, 1.0);
    layer.visible = from.flag("visible", true);
    layer.tileset = from.whole("overrideTilesetUid", from.whole("__tilesetDefUid", -1));
    readValues(from, layer);
    readTiles(from, "autoLayerTiles", layer.tiles);
    readTiles(from, "gridTiles", layer.tiles);
    for (const LdtkFields& entity : from.objects("entityInstances"))
        layer.entities.push_back(readEntity(entity));
    return layer;
}

void readBackground(const LdtkFields& from, ldtk::Level& level) {
    level.color = from.color("__bgColor", from.color("bgColor", Color{0, 0, 0, 255}));
    level.image = from.text("bgRelPath");
    const Json* place = from.find("__bgPos");
    if (place == nullptr || !place->is_object()) return;
    std::vector<Error> ignored;
    const LdtkFields fields{*place, from.where() + ".__bgPos", ignored};
    level.imageTopLeft = fields.pair("topLeftPx", {});
    level.imageScale = fields.pair("scale", {1.0f, 1.0f});
    const Json* crop = fields.find("cropRect");
    if (crop != nullptr && crop->is_array() && crop->size() == 4) {
        std::array<float, 4> sides{};
        for (std::size_t i = 0; i < 4; ++i) sides[i] = floatOf((*crop)[i]).value_or(0.0f);
        level.imageCrop = {sides[0], sides[1], sides[2], sides[3]};
        if (isPart(level.imageCrop)) return;
        from.warn("__bgPos.cropRect", "the crop is negative or too large", "save the project again in LDtk");
        level.imageCrop = {};
    }
}

void readDefinitions(const LdtkFields& from, ldtk::Project& project) {
    for (const LdtkFields& item : from.objects("tilesets")) {
        ldtk::Tileset tileset;
        tileset.uid = item.whole("uid", 0);
        tileset.name = item.text("identifier");
        tileset.image = item.text("relPath");
        tileset.imageWidth = std::clamp(item.whole("pxWid", 0), 0, limits::kImageSide);
        tileset.imageHeight = std::clamp(item.whole("pxHei", 0), 0, limits::kImageSide);
        tileset.grid = std::clamp(item.whole("tileGridSize", 16), 1, limits::kImageSide);
        tileset.spacing = std::clamp(item.whole("spacing", 0), 0, limits::kImageSide);
        tileset.padding = std::clamp(item.whole("padding", 0), 0, limits::kImageSide);
        for (const char* key : {"tags", "enumTags", "customData", "tagsSourceEnumUid", "embedAtlas"}) {
            const Json* value = item.find(key);
            if (value != nullptr && !value->empty()) tileset.notes[key] = *value;
        }
        project.tilesets.push_back(std::move(tileset));
    }
    for (const LdtkFields& item : from.objects("layers")) {
        ldtk::LayerKind kind;
        kind.uid = item.whole("uid", 0);
        kind.parallax = {static_cast<float>(item.real("parallaxFactorX", 0.0)),
                         static_cast<float>(item.real("parallaxFactorY", 0.0))};
        kind.scalesWithParallax = item.flag("parallaxScaling", true);
        kind.source = item.whole("autoSourceLayerDefUid", -1);
        kind.ruleGroups = static_cast<int>(item.objects("autoRuleGroups").size());
        for (const LdtkFields& value : item.objects("intGridValues")) {
            kind.values.push_back({value.whole("value", 0), value.text("identifier"),
                                   value.color("color", Color{128, 128, 128, 255})});
        }
        project.layers.push_back(std::move(kind));
    }
    for (const LdtkFields& item : from.objects("entities")) {
        ldtk::EntityKind kind;
        kind.uid = item.whole("uid", 0);
        kind.name = item.text("identifier");
        kind.drawnAs = item.text("renderMode");
        const std::string fill = item.text("tileRenderMode");
        const auto at = std::find(kFills.begin(), kFills.end(), fill);
        kind.fill = at == kFills.end() ? ldtk::Fill::Plain : static_cast<ldtk::Fill>(at - kFills.begin());
        kind.opacity = std::clamp(item.real("tileOpacity", 1.0), 0.0, 1.0);
        kind.resizable = item.flag("resizableX", false) || item.flag("resizableY", false);
        kind.color = item.color("color", Color{255, 255, 255, 255});
        project.entities.push_back(std::move(kind));
    }
    for (const char* key : {"enums", "externalEnums"}) {
        const Json* list = from.find(key);
        if (list == nullptr || !list->is_array()) continue;
        for (const Json& item : *list) project.enums.push_back(item);
    }
}

/// Recomputes a tile's id from its position in the image, because the saved id is wrong if the image's width
/// changed after the level was saved or is not a multiple of the tile size.
/// @return false if the tileset has no such tile
bool settleTile(ldtk::Tile& tile, const ldtk::Tileset& tileset) {
    if (tileset.imageWidth == 0 || tileset.imageHeight == 0) return true;
    const int there = tileset.tileAt(tile.sourceX, tile.sourceY);
    if (there >= 0) tile.tile = there;
    return tile.tile < tileset.columns() * tileset.rows();
}

void settleTiles(const ldtk::Project& project, const ldtk::Level& level, ldtk::Layer& layer,
                 std::vector<Error>& warnings) {
    const ldtk::Tileset* tileset = project.tileset(layer.tileset);
    if (tileset == nullptr) return;
    const auto lost = std::remove_if(layer.tiles.begin(), layer.tiles.end(),
                                     [tileset](ldtk::Tile& tile) { return !settleTile(tile, *tileset); });
    if (lost == layer.tiles.end()) return;
    warnings.push_back({format("level {}: layer {}", level.name, layer.name),
                        format("{} tiles were left out, because tileset {} has no tiles of these ids",
                               layer.tiles.end() - lost, tileset->name),
                        "check the tileset's grid, spacing and padding in LDtk"});
    layer.tiles.erase(lost, layer.tiles.end());
}

/// Reads the levels of a project, including those stored in separate files.
class LevelReader {
public:
    LevelReader(ldtk::Project& project, const FileReader& readFrom, std::vector<Error>& warnings)
        : project_{project}, readFrom_{readFrom}, warnings_{warnings} {}

    ldtk::World readWorld(const LdtkFields& from, std::string_view name) {
        ldtk::World world;
        world.name = name;
        world.iid = from.text("iid");
        world.layout = from.text("worldLayout", "Free");
        float along = 0.0f;
        for (const LdtkFields& item : from.objects("levels")) {
            std::optional<ldtk::Level> level = readNamed(item);
            if (!level) continue;
            // In linear layouts levels have an order but no valid positions (-1).
            if (world.layout == "LinearHorizontal") level->position = {along, 0.0f};
            if (world.layout == "LinearVertical") level->position = {0.0f, along};
            const int length = world.layout == "LinearVertical" ? level->height : level->width;
            along += static_cast<float>(length) + kBetweenLevels;
            world.levels.push_back(std::move(*level));
        }
        return world;
    }

private:
    std::optional<ldtk::Level> readNamed(const LdtkFields& from) {
        const std::string file = from.text("externalRelPath");
        if (file.empty()) return readLevel(from);
        const Path path = (project_.folder / file).lexically_normal();
        const Result<std::string> text =
            Path{file}.is_absolute() ? Result<std::string>{Error{file, "the path of the level is absolute",
                                                                 "save the project again in LDtk"}}
                                     : readFrom_(path);
        if (!text) {
            warnings_.push_back(text.error());
            return readLevel(from);  // the project file contains its size and fields
        }
        const Result<Json> json = parseJson(*text, file, &warnings_);
        if (!json) {
            warnings_.push_back(json.error());
            return readLevel(from);
        }
        reportUnknownLevelKeys(*json, file, project_.editorKeys, warnings_);
        return readLevel(LdtkFields{*json, file, warnings_});
    }

    std::optional<ldtk::Level> readLevel(const LdtkFields& from) {
        ldtk::Level level;
        level.name = from.text("identifier");
        level.iid = from.text("iid");
        level.position = {static_cast<float>(from.whole("worldX", 0)),
                          static_cast<float>(from.whole("worldY", 0))};
        level.depth = from.whole("worldDepth", 0);
        level.width = from.whole("pxWid", 0);
        level.height = from.whole("pxHei", 0);
        readBackground(from, level);
        level.fields = readFields(from);
        for (const LdtkFields& item : from.objects("layerInstances")) {
            if (std::optional<ldtk::Layer> layer = readLayer(item, cellsLeft_))
                level.layers.push_back(std::move(*layer));
        }
        return level;
    }

    ldtk::Project& project_;
    const FileReader& readFrom_;
    std::vector<Error>& warnings_;
    std::size_t cellsLeft_ = limits::kTiledCells;
};

}  // namespace

Result<ldtk::Project> parseLdtk(std::string_view text, const Path& file, const FileReader& readFrom,
                                std::vector<Error>& warnings) {
    const std::string where = file.filename().string();
    const Result<Json> json = parseJson(text, where, &warnings);
    if (!json) return json.error();
    const LdtkFields from{*json, where, warnings};
    if (from.find("jsonVersion") == nullptr || from.find("defs") == nullptr)
        return Error{where, "not an LDtk project", "select a file that ends in .ldtk"};
    ldtk::Project project;
    project.version = from.text("jsonVersion");
    project.folder = file.parent_path();
    reportUnknownKeys(*json, where, project.editorKeys, warnings);
    readDefinitions(LdtkFields{*from.find("defs"), where + ": defs", warnings}, project);
    if (const Json* contents = from.find("toc")) project.contents = *contents;
    LevelReader reader{project, readFrom, warnings};
    for (const LdtkFields& world : from.objects("worlds"))
        project.worlds.push_back(reader.readWorld(world, world.text("identifier", "World")));
    const Json* levels = from.find("levels");
    if (project.worlds.empty() || (levels != nullptr && !levels->empty()))
        project.worlds.insert(project.worlds.begin(), reader.readWorld(from, file.stem().string()));
    for (ldtk::World& world : project.worlds) {
        for (ldtk::Level& level : world.levels) {
            for (ldtk::Layer& layer : level.layers) settleTiles(project, level, layer, warnings);
        }
    }
    return project;
}

Result<ldtk::Project> loadLdtk(const Path& file, std::vector<Error>& warnings) {
    const FileReader readFrom = [](const Path& path) { return readFile(path); };
    const Result<std::string> text = readFrom(file);
    if (!text) return text.error();
    return parseLdtk(*text, file, readFrom, warnings);
}

}  // namespace plumb
