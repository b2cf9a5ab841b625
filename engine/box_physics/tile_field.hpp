#pragma once

#include <cstdint>
#include <vector>

#include "core/hash.hpp"
#include "core/result.hpp"
#include "box_physics/shape.hpp"

namespace plumb::box_physics {

/// What one cell of a tile field is made of. Own polygons come after `Count`.
/// Slopes: SlopeUp rises to the right by a whole cell, the others by half a cell each.
enum class TileShape : std::uint16_t {
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
    Count
};

/// A grid of solid cells as one shape. It knows which faces lie against a neighbour, so nothing that slides
/// over its tiles can trip on their borders.
class TileField {
public:
    static constexpr int kMaxShapes = 4096;

    TileField() = default;
    /// @param cellSize m, above 0
    TileField(int width, int height, Vec2 cellSize);

    /// Adds an outline for cells, in parts of a cell (0..1 from its top-left corner).
    /// @return the number to `set`
    /// @error not 3..8 finite convex points, or too many shapes
    Result<TileShape> addPolygon(const Vec2* points, int count, bool oneWay = false);

    void set(int x, int y, TileShape shape);
    /// Finds out which faces are covered; call after the last `set` and before use.
    void finish();

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] Vec2 cellSize() const { return cellSize_; }
    [[nodiscard]] std::uint64_t contentHash() const { return contentHash_; }
    [[nodiscard]] bool isSolid(int x, int y) const { return has(x, y) && cells_[slot(x, y)] != 0; }
    [[nodiscard]] bool isOneWay(int x, int y) const {
        return isSolid(x, y) && shapes_[cells_[slot(x, y)]].oneWay;
    }
    [[nodiscard]] bool isBox(int x, int y) const { return cells_[slot(x, y)] == 1; }
    /// Bits of the sides that lie against a neighbour: 1 top, 2 right, 4 bottom, 8 left.
    [[nodiscard]] unsigned coveredSides(int x, int y) const { return covered_[slot(x, y)]; }

    /// The cell's outline, relative to the field's top-left corner (m). @pre isSolid(x, y)
    [[nodiscard]] Convex outline(int x, int y) const;

private:
    /// The part of one side of a cell that a shape fills, from left to right or from top to bottom.
    struct Span {
        float from = 1.0f;
        float to = 0.0f;
    };
    struct CellShape {
        Convex convex;  // in parts of a cell
        bool oneWay = false;
        Span sides[4];
        int faceOfSide[4] = {-1, -1, -1, -1};
    };

    [[nodiscard]] bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
    [[nodiscard]] std::size_t slot(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    void addShape(const Vec2* points, int count, bool oneWay);
    [[nodiscard]] bool covers(int x, int y, int side, Span span) const;

    int width_ = 0;
    int height_ = 0;
    Vec2 cellSize_{1.0f, 1.0f};
    std::vector<std::uint16_t> cells_;
    std::vector<std::uint8_t> covered_;
    std::vector<CellShape> shapes_;
    std::uint64_t contentHash_ = 0;
};

}  // namespace plumb::box_physics
