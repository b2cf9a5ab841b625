#include "editor/model/document/tile_layers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "assets/asset_store.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/physics/tile_bodies.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

constexpr float kFarCell = 1e6f;  // cells; coordinates are clamped to this, so that they fit into an int

struct LayerPlace {
    Vec2 origin;
    Vec2 tile{16.0f, 16.0f};
};

LayerPlace placeOf(const Document& document, ObjectId layer) {
    const EntityId entity = document.find(layer);
    const Pose pose = worldPose(document.world, entity);
    const TileLayer* tiles = document.world.find<TileLayer>(entity);
    const Vec2 tile = tiles == nullptr ? Vec2{} : scaled(tileSizeOf(document.world, *tiles), pose.scale);
    LayerPlace place{pose.position};
    if (tile.x > 0.0f && tile.y > 0.0f) place.tile = tile;
    return place;
}

const TileLayer* layerOf(const Document& document, ObjectId layer) {
    return document.world.find<TileLayer>(document.find(layer));
}

/// Returns all tile layers in file order. Called every frame, so it visits only tile layers.
std::vector<ObjectId> layersInFile(const Document& document) {
    std::vector<std::pair<std::int32_t, ObjectId>> found;
    document.world.each<const TileLayer, const SceneEntity>([&](const TileLayer&, const SceneEntity& part) {
        found.emplace_back(part.order, ObjectId{part.id});
    });
    std::sort(found.begin(), found.end());
    std::vector<ObjectId> layers;
    for (const auto& [order, id] : found) layers.push_back(id);
    return layers;
}

}  // namespace

ObjectId activeTileLayer(const Document& document, const TilePaint& paint) {
    const std::vector<ObjectId> layers = layersInFile(document);
    // A scene has few layers, but thousands of entities may be selected: filter the layers, not the
    // selection.
    std::vector<ObjectId> selectedLayers;
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(selectedLayers),
                 [&](ObjectId id) { return document.selection.has(id); });
    const std::vector<ObjectId>& selected = document.selection.all();
    if (const auto first = std::find_first_of(selected.begin(), selected.end(), selectedLayers.begin(),
                                              selectedLayers.end());
        first != selected.end())
        return *first;
    if (document.world.has<TileLayer>(document.find(paint.layer))) return paint.layer;
    const auto solid = std::find_if(layers.begin(), layers.end(), [&](ObjectId id) {
        return document.world.has<TileCollider>(document.find(id));
    });
    return solid != layers.end() ? *solid : layers.empty() ? ObjectId{} : layers.front();
}

std::vector<ObjectId> tileLayers(const Document& document) {
    std::vector<ObjectId> layers = layersInFile(document);
    // Of layers with the same number `TileLayer::layer`, the later one in the file is drawn in front.
    std::reverse(layers.begin(), layers.end());
    std::stable_sort(layers.begin(), layers.end(), [&](ObjectId a, ObjectId b) {
        return layerOf(document, a)->layer > layerOf(document, b)->layer;
    });
    return layers;
}

const TileGrid* gridOf(const Document& document, ObjectId layer) {
    const TileLayer* tiles = layerOf(document, layer);
    return tiles == nullptr ? nullptr : document.world.tiles().find(tiles->cells);
}

const TileGrid* terrainOf(const Document& document, ObjectId layer) {
    const TileLayer* tiles = layerOf(document, layer);
    return tiles == nullptr ? nullptr : document.world.tiles().find(tiles->terrain);
}

const Tileset* tilesetOf(const Document& document, ObjectId layer) {
    const TileLayer* tiles = layerOf(document, layer);
    const auto* assets = document.world.service<AssetStore>();
    return tiles == nullptr || assets == nullptr ? nullptr : assets->find(tiles->tileset);
}

CellPlace cellAt(const Document& document, ObjectId layer, Vec2 point) {
    const LayerPlace place = placeOf(document, layer);
    const auto index = [](float value) {
        return static_cast<int>(std::floor(std::clamp(value, -kFarCell, kFarCell)));
    };
    const Vec2 local = point - place.origin;
    return {index(local.x / place.tile.x), index(local.y / place.tile.y)};
}

CellPlace cornerAt(const Document& document, ObjectId layer, Vec2 point) {
    return cellAt(document, layer, point + placeOf(document, layer).tile * 0.5f);
}

AABB boxOfCell(const Document& document, ObjectId layer, CellPlace cell) {
    const LayerPlace place = placeOf(document, layer);
    const Vec2 from =
        place.origin + scaled({static_cast<float>(cell.x), static_cast<float>(cell.y)}, place.tile);
    return {from, from + place.tile};
}

AABB boxOfCells(const Document& document, ObjectId layer, CellPlace a, CellPlace b) {
    return merged(boxOfCell(document, layer, a), boxOfCell(document, layer, b));
}

}  // namespace plumb::editor
