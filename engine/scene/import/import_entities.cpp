#include "scene/import/import_entities.hpp"

#include <algorithm>
#include <limits>

#include "core/text.hpp"
#include "math/tile_grid.hpp"
#include "scene/import/entity_json.hpp"
#include "scene/import/import_objects.hpp"
#include "scene/import/tiled_json.hpp"
#include "scene/tiles_json.hpp"

namespace plumb {
namespace {

using tiled::Layer;
using tiled::LayerKind;

/// Tiled moves a layer by the way of the view's middle from the map's origin of parallax, the engine by the
/// way of the view's corner from the world's origin: the difference is the same everywhere.
LayerPlace placeOf(const EntityImport& import, const Layer& layer, std::size_t index) {
    LayerPlace place;
    place.order = static_cast<int>(std::min<std::size_t>(index, kHighestLayerOrder));
    place.offset = layer.offset;
    place.moves = layer.parallax != Vec2{1.0f, 1.0f};
    const Vec2 difference = import.picture * 0.5f - import.map.parallaxOrigin;
    place.offset += {difference.x * (1.0f - layer.parallax.x), difference.y * (1.0f - layer.parallax.y)};
    return place;
}

std::vector<std::size_t> tilesetsOf(const EntityImport& import, const Layer& layer, ImportReport& report) {
    std::vector<bool> used(import.tilesets.size());
    tiled::Gid last = 0;
    int unknown = 0;
    for (const tiled::Gid gid : layer.cells) {
        if ((gid & ~tiled::kFlags) == 0) continue;
        ++report.tiles;
        if (gid == last) continue;
        const tiled::TileRef tile = import.map.resolve(gid);
        if (tile.empty()) {
            ++unknown;
        } else {
            used[static_cast<std::size_t>(tile.tileset)] = true;
            last = gid;
        }
    }
    if (unknown > 0) {
        import.stage.problems.push_back({format("layer {}", layer.name),
                                         format("{} cells name tiles that no tileset has", unknown),
                                         "add the missing tileset to the map"});
    }
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) places.push_back(i);
    }
    return places;
}

/// The cells of one tileset; those of the others stay empty.
TileGrid gridOf(const EntityImport& import, const Layer& layer, std::size_t tileset) {
    std::vector<TileCell> cells(layer.cells.size());
    const int count = import.tilesets[tileset].count;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const tiled::TileRef tile = import.map.resolve(layer.cells[i]);
        if (tile.tileset != static_cast<int>(tileset)) continue;
        // Numbers behind the end of a set whose picture is missing are kept as they are.
        if (count > 0 && tile.id >= count) continue;
        cells[i] = cellOf(tile.id, tile.flags & kTileFlips);
    }
    TileGrid grid;
    grid.replaceCells(layer.width, layer.height, std::move(cells));
    return grid;
}

/// Collects the entities of a map, layer by layer.
class EntityCollector {
public:
    explicit EntityCollector(const EntityImport& import) : import_{import} {}

    Json collect() {
        for (std::size_t i = 0; i < import_.map.layers.size(); ++i) {
            const Layer& layer = import_.map.layers[i];
            const LayerPlace place = placeOf(import_, layer, i);
            key_ = format("{}/{}/{}", layer.group, layer.name, layer.id);
            ++import_.report.layers;
            if (layer.kind == LayerKind::Tiles) addTiles(layer, place);
            if (layer.kind == LayerKind::Objects) addObjects(layer, place);
            if (layer.kind == LayerKind::Image) addImage(layer, place);
        }
        addCamera();
        return std::move(entities_);
    }

private:
    void add(std::string_view key, const std::string& name, Json components, const Layer& layer,
             bool visible) {
        entities_.push_back(
            entityJson(ids_.next(format("{}/{}", key_, key)), name, std::move(components), layer, visible));
    }

    void addTiles(const Layer& layer, const LayerPlace& place) {
        const Vec2 tileSize{static_cast<float>(import_.map.tileWidth),
                            static_cast<float>(import_.map.tileHeight)};
        const std::vector<std::size_t> used = tilesetsOf(import_, layer, import_.report);
        for (const std::size_t index : used) {
            const ImportedTileset& tileset = import_.tilesets[index];
            Json components = Json::object();
            components["Transform"] =
                transformJson(place.offset + Vec2{static_cast<float>(layer.x) * tileSize.x,
                                                  static_cast<float>(layer.y) * tileSize.y},
                              0.0f, {1.0f, 1.0f});
            Json tiles = Json::object();
            tiles["tileset"] = tileset.path;
            tiles["cells"] = tilesToJson(gridOf(import_, layer, index));
            tiles["tileSize"] = vec2Json(tileSize);
            tiles["layer"] = place.order;
            tiles["tint"] = colorOf(layer, 1.0);
            components["TileLayer"] = std::move(tiles);
            if (tileset.collides) components["TileCollider"] = Json::object();
            if (place.moves) components["ParallaxLayer"] = parallaxJson(layer);
            const std::string part = tileset.original->name;
            add(format("tiles {}", part), used.size() == 1 ? layer.name : format("{} ({})", layer.name, part),
                std::move(components), layer, true);
            if (!layer.properties.empty()) entities_.back()["properties"] = layer.properties;
        }
    }

    void addObjects(const Layer& layer, const LayerPlace& place) {
        std::vector<const tiled::Object*> order;
        for (const tiled::Object& object : layer.objects) order.push_back(&object);
        const auto higher = [](const tiled::Object* a, const tiled::Object* b) { return a->y < b->y; };
        if (layer.sortByY) std::stable_sort(order.begin(), order.end(), higher);
        for (const tiled::Object* object : order) {
            ++import_.report.objects;
            const std::string name = !object->name.empty()   ? object->name
                                     : !object->type.empty() ? object->type
                                                             : format("{} {}", layer.name, object->id);
            add(format("object {}", object->id), name, objectComponents(import_, layer, place, *object),
                layer, object->visible);
            Json& entity = entities_.back();
            if (!object->properties.empty()) entity["properties"] = object->properties;
            entity["tiled"] = objectJson(*object);
            entity["tiled"]["layer"] = layer.name;
        }
    }

    void addImage(const Layer& layer, const LayerPlace& place) {
        Json components = Json::object();
        components["Transform"] = transformJson(place.offset, 0.0f, {1.0f, 1.0f});
        if (!layer.image.empty()) {
            const StagedImage& image =
                import_.stage.image(import_.map.folder / layer.image, layer.transparent);
            Json sprite = Json::object();
            sprite["texture"] = image.path;
            sprite["width"] = std::max(image.width, 1);
            sprite["height"] = std::max(image.height, 1);
            sprite["layer"] = place.order;
            sprite["tint"] = colorOf(layer, 1.0);
            components["Sprite"] = std::move(sprite);
            if (place.moves || layer.repeatX || layer.repeatY)
                components["ParallaxLayer"] = parallaxJson(layer);
        }
        add("image", layer.name, std::move(components), layer, true);
        if (!layer.properties.empty()) entities_.back()["properties"] = layer.properties;
    }

    void addCamera() {
        const Rect bounds = boundsOf(import_.map);
        Json components = Json::object();
        components["Transform"] = transformJson(
            {bounds.x + bounds.width * 0.5f, bounds.y + bounds.height * 0.5f}, 0.0f, {1.0f, 1.0f});
        Json& camera = components["Camera"] = Json::object();
        if (!bounds.empty())
            camera["limits"] = Json::array({bounds.x, bounds.y, bounds.width, bounds.height});
        key_ = "camera";
        add("camera", "camera", std::move(components), Layer{}, true);
    }

    const EntityImport& import_;
    Json entities_ = Json::array();
    EntityIds ids_;
    std::string key_;
};

}  // namespace

Rect boundsOf(const tiled::Map& map) {
    const auto width = static_cast<float>(map.tileWidth);
    const auto height = static_cast<float>(map.tileHeight);
    if (!map.infinite) {
        return {0.0f, 0.0f, static_cast<float>(map.width) * width, static_cast<float>(map.height) * height};
    }
    AABB box;
    bool first = true;
    for (const Layer& layer : map.layers) {
        if (layer.cells.empty()) continue;
        const AABB own{{static_cast<float>(layer.x) * width, static_cast<float>(layer.y) * height},
                       {static_cast<float>(layer.x + layer.width) * width,
                        static_cast<float>(layer.y + layer.height) * height}};
        box = first ? own : merged(box, own);
        first = false;
    }
    return {box.min.x, box.min.y, box.size().x, box.size().y};
}

Json importEntities(const EntityImport& import) { return EntityCollector{import}.collect(); }

}  // namespace plumb
