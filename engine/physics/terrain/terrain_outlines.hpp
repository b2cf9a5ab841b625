#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/terrain/outlines.hpp"

namespace plumb {
class TaskPool;
}

namespace plumb::physics {

/// A terrain in chunks. Only chunks whose cells or neighbouring cells changed are rebuilt. The result of
/// update() depends on the cells only, not on the order of edits.
class TerrainOutlines {
public:
    static constexpr int kChunkCells = TileGrid::kChunkSide;

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
    /// @return the chunks whose outlines changed, ascending; valid until the next call
    std::span<const std::uint32_t> update(TaskPool* pool = nullptr);

    /// Row by row.
    [[nodiscard]] const std::vector<TerrainOutline>& chunks() const { return chunks_; }
    [[nodiscard]] CellRect cellsOf(std::uint32_t chunk) const;

private:
    /// The scratch data of one thread.
    struct Maker {
        OutlineBuilder builder;
        TerrainOutline fresh;
    };

    void markDirty(int x, int y);
    /// @return true if the chunk's outline changed
    bool makeChunk(std::uint32_t chunk, Maker& maker);

    TileMask mask_;
    int chunkCells_ = kChunkCells;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<TerrainOutline> chunks_;
    std::vector<std::uint8_t> isDirty_;  // by chunk; in update(): its outline changed
    std::vector<std::uint32_t> dirty_;
    std::vector<std::uint32_t> changed_;
    std::vector<Maker> makers_{1};  // by thread
};

}  // namespace plumb::physics
