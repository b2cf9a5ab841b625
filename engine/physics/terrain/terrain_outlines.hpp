#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "physics/geometry.hpp"
#include "physics/ids.hpp"
#include "physics/terrain/tile_mask.hpp"

namespace plumb {
class TaskPool;
}

namespace plumb::physics {

/// The properties of an edge. Edges with different properties are never merged.
struct EdgeKind {
    std::uint8_t material = 0;  ///< index in the palette
    std::uint8_t layers = 0;    ///< index in the palette
    OneWay oneWay = OneWay::No;
    /// Nonzero for an inner border: 1 + the index of the layers of the cell in front. The edge only stops
    /// bodies that do not collide with those layers; all others are stopped before they reach it.
    std::uint8_t behind = 0;

    [[nodiscard]] bool isInner() const { return behind != 0; }
    /// A solid edge that faces open space: these edges form closed outlines.
    [[nodiscard]] bool isPlain() const { return behind == 0 && oneWay == OneWay::No; }
    friend constexpr bool operator==(EdgeKind, EdgeKind) = default;
};

/// A part of a cell's outline that bodies can touch. Seen along the direction from a to b on screen (y down),
/// the solid is on the right and the normal points to the left, see normalOfChain().
struct TileEdge {
    GridPoint a;
    GridPoint b;
    EdgeKind kind;

    [[nodiscard]] constexpr GridPoint end(std::size_t i) const { return i == 0 ? a : b; }
};

/// A copy of the cells that the outlines of one chunk depend on.
class CellWindow {
public:
    void read(const TileMask& mask, CellRect rect);
    /// The number of a cell, see MaskCell; that of the cell below is `width()` further.
    [[nodiscard]] const TileCell* cell(int x, int y) const {
        return cells_.data() + std::ptrdiff_t{y - rect_.y0} * rect_.width() + (x - rect_.x0);
    }
    [[nodiscard]] int width() const { return rect_.width(); }
    /// True if all cells are equal and there are no edges between them.
    [[nodiscard]] bool isUniform() const;

private:
    CellRect rect_;
    std::vector<TileCell> cells_;
};

/// Appends the edges of the cells of `rect`, row by row, clockwise for each cell. A side is an edge where it
/// is open: where the neighbouring cell does not fill it, or fills it with other layers.
/// @pre the window extends one cell beyond `rect`
void appendEdges(const TilePalette& palette, const CellWindow& window, CellRect rect,
                 std::vector<TileEdge>& edges);

/// The successors of an edge at one of its ends.
struct EdgeLink {
    std::uint32_t outline = kNone;  ///< the next edge of the outline
    std::uint32_t ghost = kNone;    ///< the edge that bodies slide on to; kNone: the end is free
};

/// Finds how edges are connected.
///
/// Plain edges form closed outlines. Where solids touch in a single point, the outline bends within the open
/// side: no body fits through there, so each pocket becomes a plain concave corner. If their layers differ,
/// each solid keeps its own corner, as a body may collide with only one of them.
///
/// A one-way edge continues with one-way edges of the same direction. Where it ends at a solid, its ghost is
/// the solid's edge; and where the outline of a solid bends away from it, the one-way edge is the ghost of
/// the solid's edge. So bodies slide over the joint in both directions. Inner edges follow their own solid.
class EdgeLinks {
public:
    /// @param edges  start and end within `cells`; must outlive the use of this object, unchanged
    void connect(const std::vector<TileEdge>& edges, CellRect cells);

    [[nodiscard]] EdgeLink after(std::uint32_t edge) const { return find(edge, 1); }
    [[nodiscard]] EdgeLink before(std::uint32_t edge) const { return find(edge, 0); }

private:
    /// @param end  0 for what is before the edge, 1 for what is after it
    [[nodiscard]] EdgeLink find(std::uint32_t edge, std::size_t end) const;
    [[nodiscard]] bool hasOneLayer(GridPoint place) const;
    [[nodiscard]] std::size_t bucketOf(GridPoint point) const;
    /// Calls visit(number, edge) for the edges that start (0) or end (1) at a place.
    template <class Visit>
    void forEdgesAt(GridPoint place, std::size_t end, const Visit& visit) const;

    const std::vector<TileEdge>* edges_ = nullptr;
    CellRect cells_;
    std::size_t rowLength_ = 0;  // number of buckets per row
    // Linked lists of the edges by the cell in which they start (0), and by that in which they end (1): the
    // first of each cell, the others by `next`.
    std::vector<std::uint32_t> first_[2];
    std::vector<std::uint32_t> next_[2];
};

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

/// The merged edges of a chunk; connected ones of one kind follow each other, whatever edits came first.
using TerrainOutline = std::vector<TerrainSegment>;

/// @param cellSize  m
/// @param origin    of the body's frame
Geometry geometryOf(const TerrainSegment& segment, Vec2 cellSize, GridPoint origin = {});

/// Builds the outlines of chunks, and keeps its memory from one to the next. Not thread-safe.
class OutlineBuilder {
public:
    /// Builds the outline of the cells of `rect`, which depends on these and the ring of cells around them.
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
    std::vector<EdgePlace> places_;                              // parallel to the chunk's own edges
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  // by segment: its first and its last edge
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
