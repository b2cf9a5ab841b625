#include "import/import_entities.hpp"

#include <algorithm>
#include <memory>

#include "core/text.hpp"
#include "import/entity_json.hpp"
#include "import/import_objects.hpp"
#include "import/tile_colliders.hpp"
#include "import/tiled_json.hpp"
#include "math/tile_grid.hpp"
#include "scene/files/tiles_json.hpp"

namespace plumb {
namespace {

using tiled::Layer;
using tiled::LayerKind;

/// Tiled's parallax is proportional to the distance from the map's parallax origin to the view's center, the
/// engine's to the distance from the world's origin to the view's corner. They differ by a constant offset.
LayerPlacement placeOf(const EntityImport& import, const Layer& layer, std::size_t index) {
    LayerPlacement place;
    place.order = static_cast<int>(std::min<std::size_t>(index, kHighestLayerOrder));
    place.offset = layer.offset;
    place.moves = layer.parallax != Vec2{1.0f, 1.0f};
    const Vec2 difference = import.draft.place.picture * 0.5f - import.map.parallaxOrigin;
    place.offset += {difference.x * (1.0f - layer.parallax.x), difference.y * (1.0f - layer.parallax.y)};
    return place;
}

/// Returns the index of a tileset for painting in an empty layer, if possible one of the map's cell size.
std::vector<std::size_t> someTileset(const EntityImport& import) {
    for (std::size_t i = 0; i < import.tilesets.size(); ++i) {
        const tiled::Tileset& original = import.map.tilesets[i];
        const bool fits =
            original.tileWidth == import.map.tileWidth && original.tileHeight == import.map.tileHeight;
        if (fits && !original.image.empty()) return {i};
    }
    return import.tilesets.empty() ? std::vector<std::size_t>{} : std::vector<std::size_t>{0};
}

std::vector<std::size_t> tilesetsOf(const EntityImport& import, const Layer& layer) {
    ImportReport& report = import.draft.report;
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
        import.draft.report.problems.push_back(
            {format("layer {}", layer.name), format("{} cells contain tiles that are in no tileset", unknown),
             "add the missing tileset to the map"});
    }
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) places.push_back(i);
    }
    return places.empty() ? someTileset(import) : places;
}

/// Builds the grid of those cells of a layer whose tiles are from one tileset; other cells are empty.
class GridOfTileset {
public:
    GridOfTileset(const EntityImport& import, const Layer& layer, std::size_t tileset)
        : import_{import}, layer_{layer}, tileset_{tileset}, grid_{layer.width, layer.height} {}

    TileGrid make() {
        if (!layer_.cells.empty()) {
            for (int row = 0; row < grid_.chunkRows(); ++row) {
                for (int column = 0; column < grid_.chunkColumns(); ++column) fill(column, row);
            }
        }
        if (beyond_ > 0) tellBeyond();
        if (deleted_ > 0) tellDeleted();
        return std::move(grid_);
    }

private:
    void fill(int column, int row) {
        constexpr int kSide = TileGrid::kChunkSide;
        std::shared_ptr<TileGrid::Chunk> chunk;
        for (int y = row * kSide; y < std::min((row + 1) * kSide, layer_.height); ++y) {
            for (int x = column * kSide; x < std::min((column + 1) * kSide, layer_.width); ++x) {
                const TileCell cell = cellAt(x, y);
                if (cell == 0) continue;
                if (chunk == nullptr) {
                    chunk = TileGrid::filled(cell);  // filled() makes no chunk for an empty cell
                    chunk->cells = {};
                }
                chunk->cells[TileGrid::Chunk::slot(x, y)] = cell;
            }
        }
        if (chunk == nullptr) return;
        // Consecutive equal chunks, as in large uniform areas, share one object.
        if (last_ != nullptr && last_->cells == chunk->cells) chunk = last_;
        last_ = chunk;
        grid_.put(column, row, std::move(chunk));
    }

    TileCell cellAt(int x, int y) {
        const tiled::Gid gid =
            layer_.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(layer_.width) +
                         static_cast<std::size_t>(x)];
        if (gid == 0) return 0;
        const tiled::TileRef tile = import_.map.resolve(gid);
        if (tile.tileset != static_cast<int>(tileset_)) return 0;
        // Without its image a tileset's tile count is unknown (0): all tile numbers are kept.
        const ImportedTileset& tileset = import_.tilesets[tileset_];
        if (tileset.count > 0 && tile.id >= tileset.count) {
            ++beyond_;
            return 0;
        }
        if (tileset.isDeleted(tile.id)) ++deleted_;
        return cellOf(tile.id, tile.flags & kTileFlips);
    }

    void tellBeyond() {
        const ImportedTileset& tileset = import_.tilesets[tileset_];
        import_.draft.report.problems.push_back(
            {format("layer {}", layer_.name),
             format("{} cells contain tile ids beyond the {} tiles of tileset {}; they were left out",
                    beyond_, tileset.count, tileset.original->name),
             "check the tileset's image, margin and spacing in Tiled"});
    }

    void tellDeleted() {
        import_.draft.report.problems.push_back(
            {format("layer {}", layer_.name),
             format("{} cells contain tiles that tileset {} no longer has; they are kept, without a picture",
                    deleted_, import_.tilesets[tileset_].original->name),
             "add the tiles to the tileset in Tiled, or erase the cells"});
    }

    const EntityImport& import_;
    const Layer& layer_;
    std::size_t tileset_;
    TileGrid grid_;
    std::shared_ptr<TileGrid::Chunk> last_;
    int beyond_ = 0;
    int deleted_ = 0;  // number of cells with tiles that were deleted from a collection of images
};

/// Adds the entities of a map, layer by layer.
class EntityCollector {
public:
    explicit EntityCollector(const EntityImport& import) : import_{import}, draft_{import.draft} {}

    void collect() {
        for (std::size_t i = 0; i < import_.map.layers.size(); ++i) {
            const Layer& layer = import_.map.layers[i];
            const LayerPlacement place = placeOf(import_, layer, i);
            key_ = format("{}{}/{}/{}", import_.key, layer.group, layer.name, layer.id);
            ++draft_.report.layers;
            draft_.nameLayer(place.order, layer.name);
            if (layer.kind == LayerKind::Tiles) addTiles(layer, place);
            if (layer.kind == LayerKind::Objects) addObjects(layer, place);
            if (layer.kind == LayerKind::Image) addImage(layer, place);
        }
    }

private:
    void add(std::string_view key, const std::string& name, Json components, const Layer& layer,
             bool visible) {
        if (!visible || !layer.visible) components["Hidden"] = Json::object();
        draft_.add(format("{}/{}", key_, key), name, std::move(components));
    }

    void addTiles(const Layer& layer, const LayerPlacement& place) {
        const std::vector<std::size_t> used = tilesetsOf(import_, layer);
        if (used.empty()) {
            draft_.report.note(
                format("layer {}: not imported, because it is empty and the map has no tileset", layer.name));
        }
        for (const std::size_t index : used) {
            const ImportedTileset& tileset = import_.tilesets[index];
            const std::string part = tileset.original->name;
            add(format("tiles {}", part), used.size() == 1 ? layer.name : format("{} ({})", layer.name, part),
                tilesJson(layer, place, index), layer, true);
            if (!layer.properties.empty()) draft_.last()["properties"] = layer.properties;
        }
        if (!import_.map.isLattice()) return;
        if (used.size() > 1) {
            draft_.report.note(format(
                "layer {}: tiles of {} tilesets are drawn one tileset after another; where they overlap, "
                "the order may differ",
                layer.name, used.size()));
        }
        addTileColliders(import_, layer, place, key_);
    }

    Json tilesJson(const Layer& layer, const LayerPlacement& place, std::size_t index) {
        const ImportedTileset& tileset = import_.tilesets[index];
        const Vec2 tileSize{static_cast<float>(import_.map.tileWidth),
                            static_cast<float>(import_.map.tileHeight)};
        const Vec2 first{static_cast<float>(layer.x), static_cast<float>(layer.y)};
        Json components = Json::object();
        components["Transform"] = transformJson(place.offset + scaled(first, tileSize), 0.0f, {1.0f, 1.0f});
        Json tiles = Json::object();
        tiles["tileset"] = tileset.path;
        tiles["cells"] = tilesToJson(GridOfTileset{import_, layer, index}.make());
        tiles["tileSize"] = vec2Json(tileSize);
        tiles["layer"] = place.order;
        tiles["tint"] = colorOf(layer, 1.0);
        components["TileLayer"] = std::move(tiles);
        if (tileset.collides) components["TileCollider"] = Json::object();
        if (place.moves) components["ParallaxLayer"] = parallaxJson(layer);
        return components;
    }

    void addObjects(const Layer& layer, const LayerPlacement& place) {
        std::vector<const tiled::Object*> order;
        for (const tiled::Object& object : layer.objects) order.push_back(&object);
        const auto higher = [](const tiled::Object* a, const tiled::Object* b) { return a->y < b->y; };
        if (layer.sortByY) std::stable_sort(order.begin(), order.end(), higher);
        for (const tiled::Object* object : order) {
            ++draft_.report.objects;
            const std::string name = !object->name.empty()   ? object->name
                                     : !object->type.empty() ? object->type
                                                             : format("{} {}", layer.name, object->id);
            add(format("object {}", object->id), name, objectComponents(import_, layer, place, *object),
                layer, object->visible);
            Json& entity = draft_.last();
            if (!object->properties.empty()) entity["properties"] = object->properties;
            entity["tiled"] = objectJson(*object);
            entity["tiled"]["layer"] = layer.name;
        }
    }

    void addImage(const Layer& layer, const LayerPlacement& place) {
        Json components = Json::object();
        components["Transform"] = transformJson(place.offset, 0.0f, {1.0f, 1.0f});
        if (!layer.image.empty()) {
            const StagedImage& image =
                draft_.stage.image(import_.map.folder / layer.image, layer.transparent);
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
        if (!layer.properties.empty()) draft_.last()["properties"] = layer.properties;
    }

    const EntityImport& import_;
    SceneDraft& draft_;
    std::string key_;
};

}  // namespace

void importEntities(const EntityImport& import) { EntityCollector{import}.collect(); }

}  // namespace plumb
