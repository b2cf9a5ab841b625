#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/terrain/outlines.hpp"
#include "physics/terrain/pieces.hpp"

namespace plumb {
class TaskPool;
}

namespace plumb::physics {

/// What one square of a terrain gives to the physics.
struct TerrainChunk {
    TerrainOutline outline;
    std::vector<TerrainPiece> pieces;

    friend bool operator==(const TerrainChunk&, const TerrainChunk&) = default;
};

/// A terrain in chunks, of which only those are made again whose cells or neighbouring cells change. What it
/// holds after update() depends on its cells alone, not on how they came to be.
class TerrainOutlines {
public:
    static constexpr int kChunkCells = 32;

    TerrainOutlines() = default;
    /// All chunks wait for the first update().
    /// @param chunkCells  the side of a chunk (cells, 4..128)
    explicit TerrainOutlines(TileMask mask, int chunkCells = kChunkCells);

    [[nodiscard]] const TileMask& mask() const { return mask_; }
    /// To add forms, materials and layers for later set().
    [[nodiscard]] TilePalette& palette() { return mask_.palette; }

    /// As TileMask::set. Seen after the next update().
    void set(int x, int y, MaskCell cell);

    /// Makes anew what changed.
    /// @param pool  threads to share the work with; what comes of it does not depend on them
    /// @return the chunks that are others now, in rising order; valid until the next call
    std::span<const std::uint32_t> update(TaskPool* pool = nullptr);

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    /// Chunk (column, row) has the number row * columns() + column.
    [[nodiscard]] const std::vector<TerrainChunk>& chunks() const { return chunks_; }
    [[nodiscard]] CellRect cellsOf(std::uint32_t chunk) const;

private:
    /// What one thread makes chunks with.
    struct Maker {
        OutlineBuilder outlines;
        PieceBuilder pieces;
        TerrainChunk fresh;
    };

    void markDirty(int x, int y);
    /// @return whether the chunk is another one now
    bool makeChunk(std::uint32_t chunk, Maker& maker);
    /// Whether a glance tells what a chunk is like: it is empty, or among its like. @return false: it does
    /// not
    bool makePlain(std::uint32_t chunk, TerrainChunk& fresh) const;

    TileMask mask_;
    int chunkCells_ = kChunkCells;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<TerrainChunk> chunks_;
    std::vector<std::uint8_t> isDirty_;  // by chunk
    std::vector<std::uint32_t> dirty_;
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint8_t> isChanged_;  // by place in dirty_
    std::vector<Maker> makers_{1};         // by thread
};

}  // namespace plumb::physics
