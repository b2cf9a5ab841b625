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
    std::uint8_t material = 0;  ///< index of the material in the palette
    std::uint8_t layers = 0;    ///< index of the collision layers in the palette
    OneWay oneWay = OneWay::No;
    /// 0 for an edge that faces open space. For an edge between two solid cells: 1 + the palette index of the
    /// layers of the cell in front of it. Such an edge stops only bodies that pass through the cell in front.
    std::uint8_t behind = 0;

    [[nodiscard]] bool isInner() const { return behind != 0; }  ///< between solid cells
    /// True for a solid edge that faces open space. These edges form closed outlines.
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
    void read(const TileMask& mask, CellRect rect) {
        rect_ = rect;
        const auto width = static_cast<std::size_t>(rect.width());
        cells_.resize(width * static_cast<std::size_t>(rect.height()));
        TileCell* row = cells_.data();
        for (int y = rect.y0; y < rect.y1; ++y, row += width) mask.cells().copyRow(rect.x0, y, width, row);
    }
    /// Returns a pointer to a cell (see MaskCell); the cell below is `width()` elements further.
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
    std::uint32_t outline = kNone;  ///< the adjacent edge of the same outline; kNone: there is none
    std::uint32_t ghost = kNone;    ///< the edge that sliding bodies reach next; kNone: the end is free
};

/// Finds how edges are connected.
///
/// Plain edges form closed outlines. Where two solids touch in a single point, the outline passes from one to
/// the other, because no body fits between them: each open side gets a concave corner. If their layers
/// differ, each solid keeps its own convex corner, as a body may collide with only one of them.
///
/// A one-way edge continues with one-way edges of the same direction. Where it ends at a solid, its ghost is
/// the solid's edge; and where the outline of a solid bends away from it, the one-way edge is the ghost of
/// the solid's edge. So bodies slide over the joint in both directions. Inner edges follow their solid.
class EdgeLinks {
public:
    /// @param edges  start and end within `cells`; must outlive the use of this object, unchanged
    void connect(const std::vector<TileEdge>& edges, CellRect cells);

    [[nodiscard]] EdgeLink after(std::uint32_t edge) const { return find(edge, 1); }
    [[nodiscard]] EdgeLink before(std::uint32_t edge) const { return find(edge, 0); }

private:
    /// @param end  0: the edges before its start, 1: the edges after its end
    [[nodiscard]] EdgeLink find(std::uint32_t edge, std::size_t end) const;
    [[nodiscard]] bool hasOneLayer(GridPoint point) const;  // true if all plain edges there have equal layers
    [[nodiscard]] std::size_t bucketOf(GridPoint point) const {
        const GridPoint from = point - cornerOfCell(cells_.x0, cells_.y0);
        const auto row = static_cast<std::size_t>(from.y / kCellUnits);
        return row * rowLength_ + static_cast<std::size_t>(from.x / kCellUnits);
    }
    /// Calls visit(index, edge) for the edges that start (end = 0) or end (end = 1) at a point.
    template <class Visit>
    void forEdgesAt(GridPoint point, std::size_t end, const Visit& visit) const;

    const std::vector<TileEdge>* edges_ = nullptr;
    CellRect cells_;
    std::size_t rowLength_ = 0;  // number of buckets per row
    // Linked lists of the edges that start [0] or end [1] in the same cell: the first edge of each cell, and
    // for each edge the next one of its cell.
    std::vector<std::uint32_t> first_[2];
    std::vector<std::uint32_t> next_[2];
};

/// A straight part of an outline of one kind, as long as possible within its chunk. Bodies collide with the
/// side of its normal, see normalOfChain(). Ghost vertices `before` and `after`: the far ends of the adjacent
/// segments of any kind; beyond the chunk's border, the far end of the edge in the next cell; at a free end,
/// a point on the segment's straight extension.
struct TerrainSegment {
    GridPoint a;
    GridPoint b;
    GridPoint before;
    GridPoint after;
    EdgeKind kind;

    friend bool operator==(const TerrainSegment&, const TerrainSegment&) = default;
};

/// The merged edges of a chunk. Connected edges of one kind are consecutive, for any order of edits.
using TerrainOutline = std::vector<TerrainSegment>;

/// Returns the segment as a chain segment in meters. @param cellSize  size of a cell, m
/// @param origin  the point of the terrain that is the origin of the body's frame
inline Geometry geometryOf(const TerrainSegment& segment, Vec2 cellSize, GridPoint origin = {}) {
    const auto metres = [&](GridPoint point) { return toMetres(point, cellSize, origin); };
    return chainSegment(metres(segment.before), metres(segment.a), metres(segment.b), metres(segment.after));
}

/// Builds the outlines of chunks, and reuses its memory for the next chunk. Not thread-safe.
class OutlineBuilder {
public:
    /// Builds the outline of the cells of `rect`. It depends on these and the ring around them.
    void build(const TileMask& mask, CellRect rect, TerrainOutline& outline);

private:
    struct EdgePlace {
        EdgeLink before;
        EdgeLink after;
        std::uint32_t segment = kNone;  // index of the segment that contains the edge; kNone: not built yet
    };

    /// True if the next edge belongs to the same chain.
    [[nodiscard]] bool joinsNext(std::uint32_t edge) const {
        const std::uint32_t next = places_[edge].after.outline;
        return next < own_ && edges_[next].kind == edges_[edge].kind && places_[next].before.outline == edge;
    }
    [[nodiscard]] bool isStraightAfter(std::uint32_t edge) const;
    void walk(std::uint32_t start, TerrainOutline& outline);
    void setGhosts(TerrainOutline& outline) const;

    CellWindow window_;
    EdgeLinks links_;
    std::vector<TileEdge> edges_;    // the chunk's own edges, then edges of the cells around it that touch it
    std::uint32_t own_ = 0;          // number of the chunk's own edges
    std::vector<EdgePlace> places_;  // one per own edge of the chunk
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  // first and last edge of each segment
};

/// A terrain in chunks. Only chunks whose cells or neighbouring cells changed are rebuilt. The result of
/// update() depends on the cells only, not on the order of edits.
class TerrainOutlines {
public:
    static constexpr int kChunkCells = TileGrid::kChunkSide;

    TerrainOutlines() = default;
    /// Creates a terrain; the first update() builds all its chunks.
    /// @param chunkCells  the side of a chunk (cells, 4..128)
    explicit TerrainOutlines(TileMask mask, int chunkCells = kChunkCells);

    [[nodiscard]] const TileMask& mask() const { return mask_; }
    /// The palette, to add forms, materials and layers before set() uses them.
    [[nodiscard]] TilePalette& palette() { return mask_.palette; }

    /// Sets a cell, like TileMask::set(). Takes effect with the next update().
    void set(int x, int y, MaskCell cell);

    /// Rebuilds the chunks that changed.
    /// @param pool  threads to share the work; they do not affect the result
    /// @return the chunks whose outlines changed, ascending; valid until the next call
    std::span<const std::uint32_t> update(TaskPool* pool = nullptr);

    /// The outlines of all chunks, row by row.
    [[nodiscard]] const std::vector<TerrainOutline>& chunks() const { return chunks_; }
    [[nodiscard]] CellRect cellsOf(std::uint32_t chunk) const {
        const int x = static_cast<int>(chunk) % columns_ * chunkCells_;
        const int y = static_cast<int>(chunk) / columns_ * chunkCells_;
        return {x, y, std::min(x + chunkCells_, mask_.width()), std::min(y + chunkCells_, mask_.height())};
    }

private:
    struct Maker {
        OutlineBuilder builder;
        TerrainOutline fresh;  // the outline that was built last
    };

    /// @return true if the chunk's outline changed
    bool makeChunk(std::uint32_t chunk, Maker& maker);

    TileMask mask_;
    int chunkCells_ = kChunkCells;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<TerrainOutline> chunks_;
    std::vector<std::uint8_t> isDirty_;   // per chunk: 1 if it needs a rebuild; in update(): if it changed
    std::vector<std::uint32_t> dirty_;    // chunks that need a rebuild
    std::vector<std::uint32_t> changed_;  // result of update()
    std::vector<Maker> makers_{1};        // one per thread
};

}  // namespace plumb::physics
