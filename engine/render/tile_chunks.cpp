#include "render/tile_chunks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/hash.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

constexpr float kSmallestBlock = 1.5f;  ///< minimum side of a drawn block, screen px
constexpr int kHighestLevel = 9;

int chunksFor(int tiles, int side) { return (tiles + side - 1) / side; }

/// Returns the level of detail: one tile represents a block with sides of 2^level
/// tiles, so that no quad is smaller than kSmallestBlock.
int levelFor(Vec2 cellSize, float zoom) {
    const float shown = std::min(cellSize.x, cellSize.y) * zoom;
    int level = 0;
    while (level < kHighestLevel && shown * static_cast<float>(1 << level) < kSmallestBlock) ++level;
    return level;
}

/// Returns the quad of a tile, or of the block with sides of `span` tiles that it represents. Flips are
/// applied in the order diagonal, horizontal, vertical: after a diagonal flip the others act on the other
/// source axis.
SpriteInstance tileInstance(int x, int y, int span, TileCell cell, const TileLook& look,
                            const TileSheet& sheet) {
    const bool diagonal = (cell & kTileFlipDiagonal) != 0;
    const Vec2 scale = sheet.scale * static_cast<float>(span);
    Vec2 size{look.source.width * scale.x, look.source.height * scale.y};
    if (diagonal) std::swap(size.x, size.y);
    const Vec2 lowerLeft =
        scaled({static_cast<float>(x), static_cast<float>(y + span)}, sheet.cellSize) + sheet.offset;
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

/// A range of cells of the grid; right and bottom are exclusive.
struct CellRange {
    int left, top, right, bottom;
};

CellRange cellsOf(const TileGrid& grid, int chunkX, int chunkY, int width, int height) {
    return {chunkX * width, chunkY * height, std::min((chunkX + 1) * width, grid.width()),
            std::min((chunkY + 1) * height, grid.height())};
}

/// Returns by how many px the largest tile extends beyond its cell, in any orientation.
Vec2 overhangOf(const TileSheet& sheet) {
    Vec2 overhang;
    for (const TileLook& look : sheet.looks) {
        const float longest = std::max(look.source.width * sheet.scale.x, look.source.height * sheet.scale.y);
        overhang = max(overhang, Vec2{longest, longest} - sheet.cellSize);
    }
    return overhang;
}

/// Directions in which tiles extend beyond their cells, in any orientation.
struct Reach {
    bool beside = false;    ///< some tiles are wider or higher than their cells
    bool slanting = false;  ///< some are wider and higher, so they overlap the cell diagonally above
};

Reach reachOf(const TileSheet& sheet) {
    constexpr float kSlack = 0.01f;  // px: tolerance for rounding of the scale
    const Vec2 cell = sheet.cellSize + Vec2{kSlack, kSlack};
    Reach reach;
    for (const TileLook& look : sheet.looks) {
        const Vec2 size{look.source.width * sheet.scale.x, look.source.height * sheet.scale.y};
        for (const Vec2 flipped : {size, Vec2{size.y, size.x}}) {
            reach.beside = reach.beside || flipped.x > cell.x || flipped.y > cell.y;
            reach.slanting = reach.slanting || (flipped.x > cell.x && flipped.y > cell.y);
        }
    }
    return reach;
}

/// Returns the width of chunks of one row, in tiles: larger for very wide grids, to limit their number.
int rowSideFor(const TileGrid& grid) { return grid.width() > 4096 ? 1024 : 256; }

/// Calls `visit(column, row)` for the chunks of the grid that contain cells of the range.
template <class Visit>
void eachChunk(const CellRange& range, Visit visit) {
    constexpr int kSide = TileGrid::kChunkSide;
    for (int row = range.top / kSide; row * kSide < range.bottom; ++row) {
        for (int column = range.left / kSide; column * kSide < range.right; ++column) visit(column, row);
    }
}

/// Returns the tile that represents a block: its first non-empty one, or 0.
TileCell firstTile(const TileGrid& grid, const CellRange& block) {
    for (int row = block.top; row < block.bottom; ++row) {
        for (int column = block.left; column < block.right; ++column) {
            const int side = TileGrid::kChunkSide;
            if (grid.chunk(column / side, row / side) == nullptr) {
                column |= side - 1;
            } else if (const TileCell cell = grid.at(column, row); cell != 0) {
                return cell;
            }
        }
    }
    return 0;
}

/// Returns a hash that changes if a cell of the range may have changed.
std::uint64_t stampOf(const TileGrid& grid, const CellRange& range) {
    Hasher hasher;
    eachChunk(range, [&](int column, int row) {
        const TileGrid::Chunk* chunk = grid.chunk(column, row);
        hasher.add(chunk == nullptr ? 0 : chunk->stamp);
    });
    return hasher.value();
}

/// Returns a hash that changes if a cell in the range's rows may have changed: faster, but less precise.
std::uint64_t stampOfRows(const TileGrid& grid, const CellRange& range) {
    Hasher hasher;
    for (int row = range.top / TileGrid::kChunkSide; row * TileGrid::kChunkSide < range.bottom; ++row)
        hasher.add(grid.rowStamp(row));
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

/// Releases all chunks if the layer's size, the level of detail or the look of its tiles changed.
void TileChunks::prepare(const TileGrid& grid, const TileSheet& sheet, int level) {
    if (sheet.version != sheetVersion_ || sheet.cellSize != cellSize_ || columns_ == 0) {
        const Reach reach = reachOf(sheet);
        overlaps_ = reach.beside;
        byRows_ = reach.slanting;
        overhang_ = overhangOf(sheet) + Vec2{std::abs(sheet.offset.x), std::abs(sheet.offset.y)};
    }
    const int width = (byRows_ ? rowSideFor(grid) : kSide) << level;
    const int height = (byRows_ ? 1 : kSide) << level;
    const int columns = chunksFor(grid.width(), width);
    const int rows = chunksFor(grid.height(), height);
    const bool same = level == level_ && columns == columns_ && rows == rows_ && width == chunkWidth_ &&
                      height == chunkHeight_ && sheet.version == sheetVersion_ && sheet.cellSize == cellSize_;
    if (same) return;
    forget();
    level_ = level;
    columns_ = columns;
    rows_ = rows;
    chunkWidth_ = width;
    chunkHeight_ = height;
    sheetVersion_ = sheet.version;
    cellSize_ = sheet.cellSize;
    chunks_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
}

TileChunks::Range TileChunks::visibleChunks(const AABB& visible, const TileGrid& grid,
                                            const TileSheet& sheet) const {
    if (grid.width() == 0 || grid.height() == 0) return {};
    const Vec2 chunkSize =
        scaled(sheet.cellSize, {static_cast<float>(chunkWidth_), static_cast<float>(chunkHeight_)});
    const auto index = [](float position, float size, int count) {
        return std::clamp(floorToInt(position / size), 0, count);
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
    prepare(grid, sheet, levelFor(sheet.cellSize, list.view().zoom));
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
            drawChunk(list, chunk, grid, sheet, placement);
        }
    }
    if (kept_ > kMaxKept) dropUnseen();
}

/// Draws the parts of a chunk, and each animated tile after the parts below it.
void TileChunks::drawChunk(DrawList& list, const Chunk& chunk, const TileGrid& grid, const TileSheet& sheet,
                           const TilePlacement& placement) const {
    auto next = chunk.animated.begin();
    for (std::size_t part = 0; part <= chunk.parts.size(); ++part) {
        for (; next != chunk.animated.end() && next->parts == part; ++next)
            drawAnimated(list, next->cell, grid, sheet, placement);
        if (part == chunk.parts.size()) break;
        const Part& shown = chunk.parts[part];
        list.retained({shown.buffer, shown.count, shown.textures, shown.textureCount, chunk.bounds,
                       placement.offset, placement.tint, placement.layer});
    }
}

/// Builds a chunk if its cells changed. The hash of whole rows is compared first, because it is faster.
void TileChunks::refresh(Chunk& chunk, int chunkX, int chunkY, const TileGrid& grid, const TileSheet& sheet) {
    const CellRange range = cellsOf(grid, chunkX, chunkY, chunkWidth_, chunkHeight_);
    const std::uint64_t rows = stampOfRows(grid, range);
    if (chunk.known && chunk.rowsStamp == rows) return;
    const std::uint64_t stamp = stampOf(grid, range);
    if (!chunk.known || chunk.stamp != stamp) {
        release(chunk);
        build(chunk, chunkX, chunkY, grid, sheet);
        chunk.stamp = stamp;
    }
    chunk.rowsStamp = rows;
}

void TileChunks::build(Chunk& chunk, int chunkX, int chunkY, const TileGrid& grid, const TileSheet& sheet) {
    chunk.known = true;
    ++kept_;
    ++built_;
    const CellRange range = cellsOf(grid, chunkX, chunkY, chunkWidth_, chunkHeight_);
    const int span = 1 << level_;
    for (int y = range.top; y < range.bottom; y += span) {
        for (int x = range.left; x < range.right; x += span) {
            const CellRange block{x, y, std::min(x + span, range.right), std::min(y + span, range.bottom)};
            addBlock(chunk, x, y, level_ == 0 ? grid.at(x, y) : firstTile(grid, block), grid, sheet);
        }
    }
    closePart(chunk);
    if (overlaps_) return;
    // Without overlaps the order does not matter: animated tiles are drawn last.
    for (Animated& tile : chunk.animated) tile.parts = chunk.parts.size();
}

void TileChunks::addBlock(Chunk& chunk, int x, int y, TileCell cell, const TileGrid& grid,
                          const TileSheet& sheet) {
    const TileLook* look = lookOf(cell, sheet);
    if (look == nullptr) return;
    if (look->animated && level_ == 0) {
        if (overlaps_) closePart(chunk);
        chunk.animated.push_back({static_cast<std::uint32_t>(y * grid.width() + x), chunk.parts.size()});
        return;
    }
    const SpriteInstance instance = tileInstance(x, y, 1 << level_, cell, *look, sheet);
    const AABB box{instance.center - instance.half, instance.center + instance.half};
    const bool first = chunk.parts.empty() && scratch_.empty();
    chunk.bounds = first ? box : merged(chunk.bounds, box);
    addTile(chunk, instance, look->texture);
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

void TileChunks::drawAnimated(DrawList& list, std::uint32_t index, const TileGrid& grid,
                              const TileSheet& sheet, const TilePlacement& placement) {
    const int x = static_cast<int>(index) % grid.width();
    const int y = static_cast<int>(index) / grid.width();
    const TileCell cell = grid.at(x, y);
    const TileLook* look = lookOf(cell, sheet);
    if (look == nullptr) return;
    SpriteInstance instance = tileInstance(x, y, 1, cell, *look, sheet);
    instance.center += placement.offset;
    instance.tint = placement.tint;
    list.instance(instance, look->texture, placement.layer);
}

/// Releases chunks not visible in the last two frames. Rare: after much of a very large layer was visible.
void TileChunks::dropUnseen() {
    for (Chunk& chunk : chunks_) {
        if (chunk.known && chunk.lastSeen + 1 < frame_) release(chunk);
    }
}

}  // namespace plumb
