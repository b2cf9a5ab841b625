#include "import/import_tiled.hpp"

#include <algorithm>
#include <map>

#include "core/text.hpp"
#include "import/import_entities.hpp"
#include "import/import_objects.hpp"
#include "import/loaders/tmx_loader.hpp"
#include "import/map_lattice.hpp"
#include "import/orthogonal_form.hpp"
#include "import/tile_shapes.hpp"
#include "import/tiled_json.hpp"
#include "import/turned_tiles.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr std::string_view kEnding = ".scene.json";
constexpr float kFarthest = 1e7f;  // px: maximum coordinate and size of a map in its world
constexpr std::size_t kMaxMaps = 4096;

Json groupsJson(const tiled::Map& map) {
    Json groups = Json::array();
    for (const tiled::Group& group : map.groups) {
        Json json = Json::object();
        json["path"] = group.path;
        if (!group.type.empty()) json["type"] = group.type;
        if (!group.properties.empty()) json["properties"] = group.properties;
        groups.push_back(std::move(json));
    }
    return groups;
}

/// Returns the fields of Tiled layers that no component can store.
Json layersJson(const tiled::Map& map) {
    constexpr const char* kKinds[] = {"tiles", "objects", "image"};
    Json layers = Json::array();
    for (const tiled::Layer& layer : map.layers) {
        Json json = Json::object();
        json["id"] = layer.id;
        json["name"] = layer.name;
        json["kind"] = kKinds[static_cast<std::size_t>(layer.kind)];
        if (!layer.group.empty()) json["group"] = layer.group;
        if (!layer.type.empty()) json["type"] = layer.type;
        if (layer.locked) json["locked"] = true;
        if (!layer.color.empty()) json["color"] = layer.color;
        if (!layer.blend.empty()) json["blend"] = layer.blend;
        if (!layer.properties.empty()) json["properties"] = layer.properties;
        layers.push_back(std::move(json));
    }
    return layers;
}

bool isStaggered(const tiled::Map& map) {
    return map.orientation == tiled::Orientation::Staggered ||
           map.orientation == tiled::Orientation::Hexagonal;
}

Json mapJson(const tiled::Map& map) {
    Json json = Json::object();
    json["version"] = map.version;
    if (!map.type.empty()) json["type"] = map.type;
    if (map.orientation != tiled::Orientation::Orthogonal)
        json["orientation"] = std::string{tiled::nameOf(map.orientation)};
    if (map.orientation == tiled::Orientation::Hexagonal) json["hexSide"] = map.hexSide;
    if (isStaggered(map)) {
        json["staggerAxis"] = map.staggersX ? "x" : "y";
        json["staggerIndex"] = map.staggersEven ? "even" : "odd";
    }
    json["renderOrder"] = map.renderOrder;
    json["size"] = Json::array({map.width, map.height});
    json["tileSize"] = Json::array({map.tileWidth, map.tileHeight});
    if (map.infinite) json["infinite"] = true;
    if (map.parallaxOrigin != Vec2{}) json["parallaxOrigin"] = vec2Json(map.parallaxOrigin);
    json["layers"] = layersJson(map);
    if (!map.groups.empty()) json["groups"] = groupsJson(map);
    return json;
}

std::string joined(const std::set<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// True if tiles may overlap, so that the render order is visible.
bool hasLargeTiles(const tiled::Map& map) {
    return std::any_of(map.tilesets.begin(), map.tilesets.end(), [&map](const tiled::Tileset& tileset) {
        const bool larger = tileset.tileWidth > map.tileWidth || tileset.tileHeight > map.tileHeight;
        return !tileset.fitsGrid && (larger || tileset.image.empty());
    });
}

/// Adds notes about content that was imported in a different form.
void tellChanges(const tiled::Map& map, const std::vector<ImportedTileset>& tilesets, ImportReport& report) {
    int shapes = 0;
    std::set<std::string> fonts;
    for (const tiled::Layer& layer : map.layers) {
        for (const tiled::Object& object : layer.objects) {
            shapes += isOutlineLost(object) ? 1 : 0;
            if (object.shape == tiled::Shape::Text) fonts.insert(object.text.font);
        }
    }
    if (shapes > 0) {
        report.note(
            format("{} shapes have more than {} corners, which no collider supports; they are kept under "
                   "\"tiled\" in the entity",
                   shapes, kMaxOutlineCorners));
    }
    if (!fonts.empty())
        report.note(format("texts are drawn in the engine's own font instead of {}", joined(fonts)));
    const bool hasOrder = map.orientation == tiled::Orientation::Orthogonal;  // others ignore it
    if (hasOrder && map.renderOrder != "right-down" && hasLargeTiles(map)) {
        report.note(
            format("tiles are drawn from the top left to the lower right, not {}: larger ones may "
                   "overlap in a different order",
                   map.renderOrder));
    }
    for (const ImportedTileset& tileset : tilesets) {
        if (tileset.original->keepsAspect)
            report.note(format("tileset {}: tiles are stretched to their cells", tileset.original->name));
        if (!tileset.original->wangSets.empty())
            report.note(
                format("tileset {}: each color of its terrains is a terrain of its own; a tile of two colors "
                       "belongs to the later one",
                       tileset.original->name));
    }
    report.addEditorKeys("Tiled", map.editorKeys);
}

/// Imports maps into one scene. Tilesets that several maps share are written once.
class MapImporter {
public:
    explicit MapImporter(SceneDraft& draft) : draft_{draft} {}

    void add(const tiled::Map& original, const std::string& key) {
        const bool orthogonal = original.orientation == tiled::Orientation::Orthogonal;
        tiled::Map flat = orthogonal ? tiled::Map{} : orthogonalForm(original, draft_.report);
        const tiled::Map& map = orthogonal ? original : flat;
        std::vector<ImportedTileset> tilesets;
        for (const tiled::Tileset& tileset : map.tilesets) tilesets.push_back(tilesetOf(map, tileset));
        if (original.orientation == tiled::Orientation::Hexagonal)
            addTurnedTiles(flat, tilesets, draft_, key);
        TileAnimations animations;
        importEntities({map, tilesets, animations, draft_, key});
        tellChanges(original, tilesets, draft_.report);
        bounds_ = boundsOf(original);
    }

    [[nodiscard]] const Rect& bounds() const { return bounds_; }

private:
    ImportedTileset tilesetOf(const tiled::Map& map, const tiled::Tileset& tileset) {
        if (tileset.file.empty()) return imported(map, tileset);
        const std::string key = format("{}|{}|{}|{}|{}", tileset.file.generic_string(), map.tileWidth,
                                       map.tileHeight, map.wholeWidth, map.wholeHeight);
        const auto [at, isNew] = shared_.try_emplace(key);
        if (isNew) at->second = imported(map, tileset);
        ImportedTileset same = at->second;
        same.original = &tileset;
        return same;
    }
    ImportedTileset imported(const tiled::Map& map, const tiled::Tileset& tileset) {
        ++draft_.report.tilesets;
        return importTileset(map, tileset, draft_.stage);
    }

    SceneDraft& draft_;
    std::map<std::string, ImportedTileset> shared_;
    Rect bounds_;
};

struct WorldMap {
    std::string file;
    Vec2 position;
};

/// Reads the list of maps in a .world file. Patterns for map names are reported and ignored, because they
/// also match files added after the import.
Result<std::vector<WorldMap>> readWorld(const Path& file, std::vector<Error>& problems) {
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    const std::string where = file.filename().string();
    const Result<Json> json = parseJson(*text, where, &problems);
    if (!json) return json.error();
    JsonFields fields{*json, where, problems};
    if (fields.text("type", "world") != "world" || fields.find("maps") == nullptr)
        return Error{where, "this is not a Tiled world", "save it again in Tiled: World, Save World"};
    static_cast<void>(fields.flag("onlyShowAdjacentMaps", false));
    std::vector<WorldMap> maps;
    for (JsonFields& item : fields.objects("maps", kMaxMaps)) {
        WorldMap map;
        map.file = item.text("fileName");
        map.position = {item.number("x", 0.0f, -kFarthest, kFarthest),
                        item.number("y", 0.0f, -kFarthest, kFarthest)};
        static_cast<void>(item.number("width", 0.0f, 0.0f, kFarthest));
        static_cast<void>(item.number("height", 0.0f, 0.0f, kFarthest));
        item.warnUnknown();
        maps.push_back(std::move(map));
    }
    if (fields.find("patterns") != nullptr)
        fields.warn("patterns", "maps that match a pattern were left out",
                    "add these maps to the world in Tiled");
    fields.warnUnknown();
    return maps;
}

}  // namespace

Result<ImportReport> importTiled(const Path& file, const Path& scene) {
    Result<ImportTarget> place = ImportTarget::of(scene, kEnding);
    if (!place) return place.error();
    SceneDraft draft{std::move(*place)};
    draft.report.from = "Tiled map";
    const Result<tiled::Map> map = loadTiledMap(file, draft.report.problems);
    if (!map) return map.error();
    if (map->background) {
        const Color color = *map->background;
        draft.extra["background"] = colorJson({color.r, color.g, color.b, 255});
    }
    if (!map->properties.empty()) draft.extra["properties"] = map->properties;
    draft.extra["tiled"] = mapJson(*map);
    MapImporter importer{draft};
    importer.add(*map, "");
    draft.addCamera(importer.bounds());
    return draft.write();
}

Result<ImportReport> importTiledWorld(const Path& file, const Path& scene) {
    Result<ImportTarget> place = ImportTarget::of(scene, kEnding);
    if (!place) return place.error();
    SceneDraft draft{std::move(*place)};
    draft.report.from = "Tiled world";
    const Result<std::vector<WorldMap>> maps = readWorld(file, draft.report.problems);
    if (!maps) return maps.error();
    MapImporter importer{draft};
    std::optional<AABB> all;
    for (const WorldMap& named : *maps) {
        const Result<tiled::Map> map = loadTiledMap(file.parent_path() / named.file, draft.report.problems);
        if (!map) {
            draft.report.problems.push_back(map.error());
            continue;
        }
        ++draft.report.levels;
        draft.open(named.file, Path{named.file}.stem().string(), named.position);
        if (!map->properties.empty()) draft.last()["properties"] = map->properties;
        draft.last()["tiled"] = mapJson(*map);
        importer.add(*map, named.file + "/");
        const Rect own = importer.bounds();
        if (map->background) draft.addBackground(named.file + "/background", own, *map->background);
        draft.close();
        const AABB box{Vec2{own.x, own.y} + named.position,
                       Vec2{own.x + own.width, own.y + own.height} + named.position};
        all = all ? merged(*all, box) : box;
    }
    if (all) draft.addCamera({all->min.x, all->min.y, all->size().x, all->size().y});
    return draft.write();
}

}  // namespace plumb
