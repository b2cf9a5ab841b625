#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/result.hpp"
#include "math/polygon_union.hpp"
#include "math/tile_grid.hpp"
#include "math/vec2.hpp"

namespace plumb::physics {

/// Side length of a cell in "units", the integer coordinates of terrain. With integers adjacent edges match
/// exactly, areas are exact sums and a rebuild gives the same bits. All common tile sizes (16, 18, 20, 24,
/// 32, 48, 64 px …) divide the value, 2^8 * 45, so that their pixels are whole numbers of units too.
inline constexpr std::int32_t kCellUnits = 11520;

constexpr GridPoint cornerOfCell(int x, int y) { return {x * kCellUnits, y * kCellUnits}; }  // top left

/// Converts units to meters. @param cellSize  size of a cell, m
/// @param origin  the point that maps to {0, 0}; that of a chunk keeps the numbers small and floats accurate
constexpr Vec2 toMetres(GridPoint point, Vec2 cellSize, GridPoint origin = {}) {
    const GridPoint from = point - origin;
    return {static_cast<float>(static_cast<double>(from.x) / kCellUnits * static_cast<double>(cellSize.x)),
            static_cast<float>(static_cast<double>(from.y) / kCellUnits * static_cast<double>(cellSize.y))};
}

/// The outline of a cell. Slopes go "Up" or "Down" from left to right; Low and High are the two halves of a
/// slope that spans two cells. Forms that are added to a palette follow from `Count` on.
enum class TileForm : std::uint16_t {
    Empty,
    Full,
    OneWay,
    SlopeUp,
    SlopeDown,
    SlopeUpLow,
    SlopeUpHigh,
    SlopeDownHigh,
    SlopeDownLow,
    HalfTop,
    HalfBottom,
    HalfLeft,
    HalfRight,
    Count
};

/// The side on which a one-way form stops bodies; bodies pass through it from all other sides.
enum class OneWay : std::uint8_t { No, Up, Right, Down, Left };

/// The outward normal of the side that stops bodies, for ShapeDefinition::oneWayDirection. {0, 0} for No.
constexpr GridPoint directionOf(OneWay side) {
    constexpr GridPoint kDirections[] = {{0, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    return kDirections[static_cast<int>(side)];
}

struct TileMaterial {
    float friction = 0.6f;      ///< Coulomb coefficient, 0..100
    float bounciness = 0.0f;    ///< coefficient of restitution, 0..1
    float surfaceSpeed = 0.0f;  ///< m/s: speed of a conveyor belt, from a to b of its segments

    friend constexpr bool operator==(const TileMaterial&, const TileMaterial&) = default;
};

/// The collision filter of cells, as in a ShapeDefinition.
struct TileLayers {
    std::uint32_t layers = 1;          ///< bits: the layers that the cells are on
    std::uint32_t mask = 0xffffffffu;  ///< bits: the layers that the cells collide with

    friend constexpr bool operator==(const TileLayers&, const TileLayers&) = default;
};

/// The part of a side of a cell that a solid form fills (units, from left to right or from top to bottom).
/// Empty if only a corner touches the side (both numbers are its position).
struct FaceSpan {
    std::int32_t from = 0;
    std::int32_t to = 0;

    [[nodiscard]] constexpr bool empty() const { return from >= to; }
    friend constexpr bool operator==(FaceSpan, FaceSpan) = default;
};

/// The sides of a cell, clockwise on screen like the corners of an outline; kInside: on none of them.
enum CellSide : std::int8_t { kTop, kRight, kBottom, kLeft, kInside = -1 };

/// The constant coordinate (units) of a side: y of the top and bottom, x of the left and right side.
constexpr std::int32_t lineOf(CellSide side) { return side == kRight || side == kBottom ? kCellUnits : 0; }
/// Orders the coordinates of a point as {along the side, across the side}, or back to {x, y}.
constexpr GridPoint alongFirst(CellSide side, GridPoint point) {
    return side == kTop || side == kBottom ? point : GridPoint{point.y, point.x};
}

/// The geometry of a form within the cell: closed outlines that do not cross. Forms that are one convex
/// polygon begin at its topmost corner (of several, the leftmost) and go around it, clockwise on screen.
struct TileOutline {
    /// Seen from a to b on screen (y down), the solid is on the right.
    struct Edge {
        GridPoint a;
        GridPoint b;
        CellSide side = kInside;  ///< the cell side on which the edge lies
        bool stops = true;        ///< the edge stops bodies; true for all edges of a solid form

        friend constexpr bool operator==(const Edge&, const Edge&) = default;
    };

    std::vector<Edge> edges;
    /// The parts of each side that a solid form fills or touches, in order; empty for one-way forms.
    std::array<std::vector<FaceSpan>, 4> spans;
    OneWay oneWay = OneWay::No;

    [[nodiscard]] bool isSolid() const { return !edges.empty() && oneWay == OneWay::No; }

    friend bool operator==(const TileOutline&, const TileOutline&) = default;
};

/// The forms, materials and layers that the cells of a terrain refer to by index. Index 0 is the empty form,
/// the default material and the default layers. A palette only grows, so indices stay valid; adding an
/// existing entry returns its index.
class TilePalette {
public:
    static constexpr std::size_t kMaxForms = 16384;
    static constexpr std::ptrdiff_t kMaxTouching = 2;  ///< outlines of a form that meet in a point
    static constexpr std::size_t kMaxCorners = 256;    ///< of all polygons of a form, before they are joined
    static constexpr std::size_t kMaxMaterials = 256;
    static constexpr std::size_t kMaxLayers = 255;

    TilePalette();

    /// Adds a custom form, in fractions of a cell (0..1 from its top-left corner), clockwise or
    /// counter-clockwise. Corners within 1/256 of a border are moved onto it, so that tiles leave no gaps.
    /// @error not a convex polygon of 3 to 8 corners inside the cell, or too many forms
    Result<TileForm> addPolygon(std::span<const Vec2> points, OneWay oneWay = OneWay::No);

    /// Adds a form that fills the union of polygons, which may be concave and overlap; corners are given and
    /// moved like those of addPolygon(). A polygon that crosses itself has holes.
    /// @error a corner is outside the cell, more than kMaxCorners corners, no area, outlines that cross in
    /// too many places or of which more than two meet in a point, or too many forms
    Result<TileForm> addPolygons(std::span<const std::vector<Vec2>> polygons, OneWay oneWay = OneWay::No);

    /// Returns the form flipped like a cell of a TileGrid. A one-way form stays solid on the same side.
    /// @param flips  bits of kTileFlips
    /// @error too many forms
    Result<TileForm> flipped(TileForm form, TileCell flips);

    /// Returns the form that stops bodies on one side only, or (OneWay::No) on all sides.
    /// @error too many forms
    Result<TileForm> withOneWay(TileForm form, OneWay oneWay);

    /// @error a number is out of its range, or too many materials
    Result<std::uint8_t> addMaterial(const TileMaterial& material);
    /// @error too many layers
    Result<std::uint8_t> addLayers(const TileLayers& layers);

    [[nodiscard]] const TileOutline& outline(TileForm form) const {
        return forms_[static_cast<std::size_t>(form)];
    }
    [[nodiscard]] const TileMaterial& material(std::uint8_t number) const { return materials_[number]; }
    [[nodiscard]] const TileLayers& layers(std::uint8_t number) const { return layers_[number]; }

    [[nodiscard]] bool hasForm(TileForm form) const { return static_cast<std::size_t>(form) < forms_.size(); }
    [[nodiscard]] bool has(TileForm form, std::uint8_t material, std::uint8_t layers) const {
        return hasForm(form) && material < materials_.size() && layers < layers_.size();
    }

    /// True if all bodies that collide with layers() `covered` also collide with layers() `cover`.
    [[nodiscard]] bool covers(std::uint8_t cover, std::uint8_t covered) const {
        const TileLayers &over = layers_[cover], &under = layers_[covered];
        return (under.layers & ~over.layers) == 0 && (under.mask & ~over.mask) == 0;
    }

private:
    Result<TileForm> add(const TileOutline& outline);

    std::vector<TileOutline> forms_;
    std::vector<TileMaterial> materials_;
    std::vector<TileLayers> layers_;
};

/// A cell of a terrain: indices in its palette. A TileGrid stores it as a TileCell; 0 is the empty cell.
struct MaskCell {
    TileForm form = TileForm::Empty;
    std::uint8_t material = 0;
    std::uint8_t layers = 0;

    friend constexpr bool operator==(MaskCell, MaskCell) = default;
};
constexpr MaskCell maskCellOf(TileCell number) { return std::bit_cast<MaskCell>(number); }
constexpr TileCell numberOf(MaskCell cell) { return std::bit_cast<TileCell>(cell); }

/// A rectangle of cells: columns x0 to x1 - 1, rows y0 to y1 - 1.
struct CellRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] constexpr int width() const { return x1 - x0; }
    [[nodiscard]] constexpr int height() const { return y1 - y0; }
    [[nodiscard]] constexpr CellRect grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
};

/// A grid of cells and their palette, from which a terrain is built. Outside of it all cells are empty.
class TileMask {
public:
    static constexpr int kMaxSide = 65536;
    static constexpr int kMaxCells = 1 << 28;

    /// Cells, row by row.
    using Chunk = std::array<MaskCell, std::size_t{TileGrid::kChunkSide} * TileGrid::kChunkSide>;

    TilePalette palette;

    TileMask() = default;
    /// Creates a grid of empty cells. Sides are clamped to 0..kMaxSide; rows beyond kMaxCells are dropped.
    TileMask(int width, int height);

    /// All cells as TileCell values; maskCellOf() converts them.
    [[nodiscard]] const TileGrid& cells() const { return cells_; }
    [[nodiscard]] int width() const { return cells_.width(); }
    [[nodiscard]] int height() const { return cells_.height(); }
    [[nodiscard]] MaskCell at(int x, int y) const { return maskCellOf(cells_.at(x, y)); }

    /// Does nothing outside the grid.
    /// @return true if the cell changed
    /// @pre    the cell's form, material and layers are in the palette; otherwise it is not set
    bool set(int x, int y, MaskCell cell);

    /// Replaces all cells of a chunk at once; its first cell is (column, row) * TileGrid::kChunkSide. Cells
    /// outside the grid are ignored. Uniform chunks with equal cells share their memory.
    /// @pre the cells' forms, materials and layers are in the palette
    void putChunk(int column, int row, const Chunk& cells);
    /// Replaces all cells of a chunk with the same cell, like putChunk().
    void putPlain(int column, int row, MaskCell cell);
    /// True if a fast test shows that a chunk has no edges: it is empty, or it and its eight neighbours are
    /// filled with the same full cell. May be false for a chunk without edges.
    [[nodiscard]] bool isPlain(int column, int row) const;

private:
    [[nodiscard]] bool knows(MaskCell cell) const {
        return palette.has(cell.form, cell.material, cell.layers);
    }

    TileGrid cells_;
    /// References to all uniform chunks: a chunk with this second reference is copied before it is changed.
    std::vector<std::shared_ptr<TileGrid::Chunk>> plains_;
};

}  // namespace plumb::physics
