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

/// The physics data of one chunk of a terrain.
struct TerrainChunk {
    TerrainOutline outline;
    std::vector<TerrainPiece> pieces;

    friend bool operator==(const TerrainChunk&, const TerrainChunk&) = default;
};

/// A terrain in chunks. Only chunks whose cells or neighbouring cells changed are rebuilt. The result of
/// update() depends on the cells only, not on the order of edits.
class TerrainOutlines {
public:
    static constexpr int kChunkCells = 32;

    TerrainOutlines() = default;
    /// All chunks are built by the first update().
    /// @param chunkCells  the side of a chunk (cells, 4..128)
    explicit TerrainOutlines(TileMask mask, int chunkCells = kChunkCells);

    [[nodiscard]] const TileMask& mask() const { return mask_; }
    /// For adding the forms, materials and layers of later set() calls.
    [[nodiscard]] TilePalette& palette() { return mask_.palette; }

    /// As TileMask::set(). Takes effect with the next update().
    void set(int x, int y, MaskCell cell);

    /// Rebuilds the chunks that changed.
    /// @param pool  threads to share the work; they do not affect the result
    /// @return the chunks whose data changed, ascending; valid until the next call
    std::span<const std::uint32_t> update(TaskPool* pool = nullptr);

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    /// Chunk (column, row) has the index row * columns() + column.
    [[nodiscard]] const std::vector<TerrainChunk>& chunks() const { return chunks_; }
    [[nodiscard]] CellRect cellsOf(std::uint32_t chunk) const;

private:
    /// The scratch data of one thread.
    struct Maker {
        OutlineBuilder outlines;
        PieceBuilder pieces;
        TerrainChunk fresh;
    };

    void markDirty(int x, int y);
    /// @return true if the chunk's data changed
    bool makeChunk(std::uint32_t chunk, Maker& maker);
    /// Fast path: builds a chunk that is uniformly empty, or uniformly full and surrounded by the same cells.
    /// @return false if the chunk is neither
    bool makePlain(std::uint32_t chunk, TerrainChunk& fresh) const;

    TileMask mask_;
    int chunkCells_ = kChunkCells;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<TerrainChunk> chunks_;
    std::vector<std::uint8_t> isDirty_;  // by chunk
    std::vector<std::uint32_t> dirty_;
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint8_t> isChanged_;  // parallel to dirty_
    std::vector<Maker> makers_{1};         // by thread
};

}  // namespace plumb::physics
