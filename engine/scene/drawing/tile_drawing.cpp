#include "scene/drawing/tile_drawing.hpp"

#include <algorithm>

#include "scene/effects.hpp"

namespace plumb {
namespace {

/// Number of frames after which the memory of a tile layer that was not drawn is freed.
constexpr std::uint64_t kForgetFrames = 300;

}  // namespace

bool isAnimated(const Tileset& tileset) {
    return std::any_of(tileset.tiles.begin(), tileset.tiles.end(),
                       [](const Tile& tile) { return !tile.animation.empty(); });
}

void TileDrawing::beginFrame(double seconds) {
    seconds_ = seconds;
    ++frame_;
    const auto unseen = [this](const Layer& layer) { return layer.drawnFrame + kForgetFrames < frame_; };
    layers_.erase(std::remove_if(layers_.begin(), layers_.end(), unseen), layers_.end());
}

void TileDrawing::draw(const World& world, EntityId entity, const TileLayer& layer, const Pose& pose,
                       DrawList& list) {
    const TileGrid* grid = world.tiles().find(layer.cells);
    if (grid == nullptr || layer.tileset.empty()) return;
    double seconds = seconds_;
    if (Effects* effects = world.service<Effects>();
        effects != nullptr && isAnimated(assets_.tileset(layer.tileset))) {
        if (effects->pinOf(effects->table().find("tile_animation")) == Pin::Off) {
            seconds = 0.0;
        } else {
            effects->count("tile_animation");
        }
    }
    TileSheet sheet =
        looksOf(layer.tileset).sheet(assets_, textures_, layer.tileset, layer.tileSize, seconds);
    sheet.cellSize = scaled(sheet.cellSize, pose.scale);
    sheet.scale = scaled(sheet.scale, pose.scale);
    sheet.offset = scaled(sheet.offset, pose.scale);
    chunksOf(entity, layer, pose.scale).draw(list, *grid, sheet, {pose.position, layer.tint, layer.layer});
}

TilesetLooks& TileDrawing::looksOf(TilesetId id) {
    for (const auto& sheet : sheets_) {
        if (sheet->tileset == id) return sheet->looks;
    }
    Sheet& sheet = *sheets_.emplace_back(std::make_unique<Sheet>());
    sheet.tileset = id;
    return sheet.looks;
}

TileChunks& TileDrawing::chunksOf(EntityId entity, const TileLayer& layer, Vec2 scale) {
    auto at =
        std::find_if(layers_.begin(), layers_.end(), [&](const Layer& l) { return l.entity == entity; });
    if (at == layers_.end()) {
        at = layers_.insert(layers_.end(), Layer{entity, layer.cells, layer.tileset, scale, 0, nullptr});
        at->chunks = std::make_unique<TileChunks>(device_);
    }
    if (!(at->cells == layer.cells && at->tileset == layer.tileset && at->scale == scale)) {
        at->chunks->forget();
        at->cells = layer.cells;
        at->tileset = layer.tileset;
        at->scale = scale;
    }
    at->drawnFrame = frame_;
    return *at->chunks;
}

}  // namespace plumb
