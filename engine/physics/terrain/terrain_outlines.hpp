#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/model/geometry.hpp"
#include "physics/terrain/tile_edges.hpp"

namespace plumb {
class TaskPool;
}

namespace plumb::physics {

/// A straight part of an outline of one kind, as long as possible within its chunk. It is solid on the side
/// of its normal, see normalOfChain(). The ghost vertices are the far ends of the segments before and after,
/// even if their kind differs; outside the chunk, the far end of the edge in the next cell. At a free end
/// they continue straight on.
struct TerrainSegment {
    GridPoint a;
    GridPoint b;
    GridPoint before;
    GridPoint after;
    EdgeKind kind;

    friend bool operator==(const TerrainSegment&, const TerrainSegment&) = default;
};

/// The merged edges of a chunk; connected ones of one kind follow each other. It depends on the cells only,
/// not on the order of edits.
using TerrainOutline = std::vector<TerrainSegment>;

/// @param cellSize  m
/// @param origin    of the body's frame
Geometry geometryOf(const TerrainSegment& segment, Vec2 cellSize, GridPoint origin = {});

/// Builds the outlines of chunks, and keeps its memory from one to the next. Not thread-safe.
class OutlineBuilder {
public:
    /// Builds the outline of the cells of `rect`. It depends only on these and on the ring of cells around
    /// them.
    void build(const TileMask& mask, CellRect rect, TerrainOutline& outline);

private:
    struct EdgePlace {
        EdgeLink before;
        EdgeLink after;
        std::uint32_t segment = kNone;
    };

    [[nodiscard]] bool joinsNext(std::uint32_t edge) const;
    [[nodiscard]] bool isStraightAfter(std::uint32_t edge) const;
    void walk(std::uint32_t start, TerrainOutline& outline);
    void setGhosts(TerrainOutline& outline) const;

    CellWindow window_;
    EdgeLinks links_;
    std::vector<TileEdge> edges_;  // the chunk's own edges, then those around it that touch its border
    std::uint32_t own_ = 0;
    std::vector<EdgePlace> places_;         // parallel to the chunk's own edges
    std::vector<std::uint32_t> firstEdge_;  // by segment
    std::vector<std::uint32_t> lastEdge_;
};

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
