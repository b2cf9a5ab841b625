#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/terrain/outlines.hpp"
#include "physics/terrain/pieces.hpp"

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
    /// @return the chunks that are others now, in rising order; valid until the next call
    std::span<const std::uint32_t> update();

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    /// Chunk (column, row) has the number row * columns() + column.
    [[nodiscard]] const std::vector<TerrainChunk>& chunks() const { return chunks_; }
    [[nodiscard]] CellRect cellsOf(std::uint32_t chunk) const;

private:
    void markDirty(int x, int y);

    TileMask mask_;
    int chunkCells_ = kChunkCells;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<TerrainChunk> chunks_;
    std::vector<std::uint8_t> isDirty_;  // by chunk
    std::vector<std::uint32_t> dirty_;
    std::vector<std::uint32_t> changed_;
    TerrainChunk fresh_;
    OutlineBuilder outlines_;
    PieceBuilder pieces_;
};

}  // namespace plumb::physics
