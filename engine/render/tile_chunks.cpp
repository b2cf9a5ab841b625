#include "render/tile_chunks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/hash.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

int chunksFor(int tiles) { return (tiles + TileChunks::kSide - 1) / TileChunks::kSide; }

/// The quad of one tile. Diagonal, horizontal, vertical: with the first, the others turn the other axis of
/// the source.
SpriteInstance tileInstance(int x, int y, TileCell cell, const TileLook& look, const TileSheet& sheet) {
    const bool diagonal = (cell & kTileFlipDiagonal) != 0;
    Vec2 size{look.source.width * sheet.scale.x, look.source.height * sheet.scale.y};
    if (diagonal) std::swap(size.x, size.y);
    const Vec2 lowerLeft =
        scaled({static_cast<float>(x), static_cast<float>(y + 1)}, sheet.cellSize) + sheet.offset;
    SpriteInstance instance;
    instance.half = size * 0.5f;
    instance.center = {lowerLeft.x + instance.half.x, lowerLeft.y - instance.half.y};
    const Rect& source = look.source;
    instance.uv = {uvFromTexels(source.x), uvFromTexels(source.y), uvFromTexels(source.x + source.width),
                   uvFromTexels(source.y + source.height)};
    const bool flipU = (cell & (diagonal ? kTileFlipY : kTileFlipX)) != 0;
    const bool flipV = (cell & (diagonal ? kTileFlipX : kTileFlipY)) != 0;
    if (flipU) std::swap(instance.uv[0], instance.uv[2]);
    if (flipV) std::swap(instance.uv[1], instance.uv[3]);
    instance.slot = diagonal ? kSpriteDiagonal : 0u;
    return instance;
}

const TileLook* lookOf(TileCell cell, const TileSheet& sheet) {
    const int tile = tileOf(cell);
    if (tile < 0 || static_cast<std::size_t>(tile) >= sheet.looks.size()) return nullptr;
    const TileLook& look = sheet.looks[static_cast<std::size_t>(tile)];
    return look.source.empty() ? nullptr : &look;
}

/// The cells of one chunk, cut off at the grid's edge.
template <class Visit>
void eachCell(const TileGrid& grid, int chunkX, int chunkY, Visit&& visit) {
    const int right = std::min((chunkX + 1) * TileChunks::kSide, grid.width());
    const int bottom = std::min((chunkY + 1) * TileChunks::kSide, grid.height());
    for (int y = chunkY * TileChunks::kSide; y < bottom; ++y) {
        for (int x = chunkX * TileChunks::kSide; x < right; ++x) visit(x, y, grid.at(x, y));
    }
}

std::uint64_t hashOf(const TileGrid& grid, int chunkX, int chunkY) {
    Hasher hasher;
    const int left = chunkX * TileChunks::kSide;
    const int width = std::min(TileChunks::kSide, grid.width() - left);
    const int bottom = std::min((chunkY + 1) * TileChunks::kSide, grid.height());
    for (int y = chunkY * TileChunks::kSide; y < bottom; ++y) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width());
        hasher.addBytes(grid.cells().data() + row + static_cast<std::size_t>(left),
                        static_cast<std::size_t>(width) * sizeof(TileCell));
    }
    return hasher.value();
}

}  // namespace

void TileChunks::forget() {
    for (Chunk& chunk : chunks_) release(chunk);
    chunks_.clear();
    columns_ = rows_ = 0;
}

void TileChunks::release(Chunk& chunk) {
    for (const Part& part : chunk.parts) device_.destroyInstances(part.buffer);
    if (chunk.known) --kept_;
    chunk = {};
}

/// Starts anew when the layer has another size or its tiles look different.
void TileChunks::prepare(const TileGrid& grid, const TileSheet& sheet) {
    const int columns = chunksFor(grid.width());
    const int rows = chunksFor(grid.height());
    const bool same =
        columns == columns_ && rows == rows_ && sheet.version == sheetVersion_ && sheet.cellSize == cellSize_;
    if (same) return;
    forget();
    columns_ = columns;
    rows_ = rows;
    sheetVersion_ = sheet.version;
    cellSize_ = sheet.cellSize;
    chunks_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    overhang_ = {};
    for (const TileLook& look : sheet.looks) {
        const float longest = std::max(look.source.width * sheet.scale.x, look.source.height * sheet.scale.y);
        overhang_ = max(overhang_, Vec2{longest, longest} - sheet.cellSize);
    }
    overhang_ += {std::abs(sheet.offset.x), std::abs(sheet.offset.y)};
}

TileChunks::Range TileChunks::visibleChunks(const AABB& visible, const TileGrid& grid,
                                            const TileSheet& sheet) const {
    if (grid.width() == 0 || grid.height() == 0) return {};
    const Vec2 chunkSize = sheet.cellSize * static_cast<float>(kSide);
    const auto index = [](float place, float size, int count) {
        return std::clamp(floorToInt(place / size), 0, count);
    };
    Range range;
    range.left = index(visible.min.x - overhang_.x, chunkSize.x, columns_);
    range.top = index(visible.min.y - overhang_.y, chunkSize.y, rows_);
    range.right = index(visible.max.x + overhang_.x + chunkSize.x, chunkSize.x, columns_);
    range.bottom = index(visible.max.y + overhang_.y + chunkSize.y, chunkSize.y, rows_);
    return range;
}

void TileChunks::draw(DrawList& list, const TileGrid& grid, const TileSheet& sheet,
                      const TilePlacement& placement) {
    if (sheet.cellSize.x <= 0.0f || sheet.cellSize.y <= 0.0f) return;
    prepare(grid, sheet);
    ++frame_;
    const AABB box = visibleBox(list.view());
    const AABB visible{box.min - placement.offset, box.max - placement.offset};
    const Range range = visibleChunks(visible, grid, sheet);
    for (int y = range.top; y < range.bottom; ++y) {
        for (int x = range.left; x < range.right; ++x) {
            Chunk& chunk = chunks_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                                   static_cast<std::size_t>(x)];
            refresh(chunk, x, y, grid, sheet);
            chunk.lastSeen = frame_;
            for (const Part& part : chunk.parts) {
                list.retained({part.buffer, part.count, part.textures, part.textureCount, chunk.bounds,
                               placement.offset, placement.tint, placement.layer});
            }
            drawAnimated(list, chunk, grid, sheet, placement);
        }
    }
    if (kept_ > kMaxKept) dropUnseen();
}

/// Most changes of a grid touch one chunk: the others find that their own cells are as they were.
void TileChunks::refresh(Chunk& chunk, int chunkX, int chunkY, const TileGrid& grid, const TileSheet& sheet) {
    if (chunk.known && chunk.gridVersion == grid.version()) return;
    const std::uint64_t hash = hashOf(grid, chunkX, chunkY);
    if (!chunk.known || chunk.cellsHash != hash) {
        release(chunk);
        build(chunk, chunkX, chunkY, grid, sheet);
        chunk.cellsHash = hash;
    }
    chunk.gridVersion = grid.version();
}

void TileChunks::build(Chunk& chunk, int chunkX, int chunkY, const TileGrid& grid, const TileSheet& sheet) {
    chunk.known = true;
    ++kept_;
    ++built_;
    bool first = true;
    eachCell(grid, chunkX, chunkY, [&](int x, int y, TileCell cell) {
        const TileLook* look = lookOf(cell, sheet);
        if (look == nullptr) return;
        if (look->animated) {
            chunk.animated.push_back(static_cast<std::uint32_t>(y * grid.width() + x));
            return;
        }
        const SpriteInstance instance = tileInstance(x, y, cell, *look, sheet);
        const AABB box{instance.center - instance.half, instance.center + instance.half};
        chunk.bounds = std::exchange(first, false) ? box : merged(chunk.bounds, box);
        addTile(chunk, instance, look->texture);
    });
    closePart(chunk);
}

void TileChunks::addTile(Chunk& chunk, const SpriteInstance& instance, TextureHandle texture) {
    const auto end = open_.textures.begin() + static_cast<std::ptrdiff_t>(open_.textureCount);
    auto known = std::find(open_.textures.begin(), end, texture);
    if (known == end) {
        if (open_.textureCount == kTextureSlots) closePart(chunk);
        known = open_.textures.begin() + static_cast<std::ptrdiff_t>(open_.textureCount);
        open_.textures[open_.textureCount++] = texture;
    }
    scratch_.push_back(instance);
    scratch_.back().slot |= static_cast<std::uint32_t>(known - open_.textures.begin());
}

void TileChunks::closePart(Chunk& chunk) {
    if (!scratch_.empty()) {
        open_.buffer = device_.createInstances(scratch_);
        open_.count = scratch_.size();
        chunk.parts.push_back(open_);
    }
    open_ = {};
    scratch_.clear();
}

void TileChunks::drawAnimated(DrawList& list, const Chunk& chunk, const TileGrid& grid,
                              const TileSheet& sheet, const TilePlacement& placement) const {
    for (const std::uint32_t place : chunk.animated) {
        const int x = static_cast<int>(place) % grid.width();
        const int y = static_cast<int>(place) / grid.width();
        const TileCell cell = grid.at(x, y);
        const TileLook* look = lookOf(cell, sheet);
        if (look == nullptr) continue;
        SpriteInstance instance = tileInstance(x, y, cell, *look, sheet);
        instance.center += placement.offset;
        instance.tint = placement.tint;
        list.instance(instance, look->texture, placement.layer);
    }
}

/// Frees what the last frames did not see. Rare: only when very much of a very large layer was seen.
void TileChunks::dropUnseen() {
    for (Chunk& chunk : chunks_) {
        if (chunk.known && chunk.lastSeen + 1 < frame_) release(chunk);
    }
}

}  // namespace plumb
