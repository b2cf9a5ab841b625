#pragma once

#include <cstdint>

#include "math/vec2.hpp"

namespace plumb::physics {

/// The side of a cell in units. Terrain has integer coordinates, so that adjacent edges match exactly, areas
/// are exact sums and a rebuild gives the same bits. The value is 2^8 * 45: all common tile sizes (16, 18,
/// 20, 24, 32, 48, 64 px …) divide it, so their pixels are whole numbers of units too.
inline constexpr std::int32_t kCellUnits = 11520;

/// A position in a terrain (units from its top-left corner, y down).
struct GridPoint {
    std::int32_t x = 0;
    std::int32_t y = 0;

    friend constexpr bool operator==(GridPoint, GridPoint) = default;
};

constexpr GridPoint operator+(GridPoint a, GridPoint b) { return {a.x + b.x, a.y + b.y}; }
constexpr GridPoint operator-(GridPoint a, GridPoint b) { return {a.x - b.x, a.y - b.y}; }
constexpr std::int64_t dot(GridPoint a, GridPoint b) {
    return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y;
}
constexpr std::int64_t cross(GridPoint a, GridPoint b) {
    return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

/// The top-left corner of a cell.
constexpr GridPoint cornerOfCell(int x, int y) { return {x * kCellUnits, y * kCellUnits}; }

/// @param cellSize  m
/// @param origin    maps to {0, 0}; the origin of a chunk keeps the numbers small, so that floats stay
/// accurate
constexpr Vec2 toMetres(GridPoint point, Vec2 cellSize, GridPoint origin = {}) {
    const GridPoint from = point - origin;
    return {static_cast<float>(static_cast<double>(from.x) / kCellUnits * static_cast<double>(cellSize.x)),
            static_cast<float>(static_cast<double>(from.y) / kCellUnits * static_cast<double>(cellSize.y))};
}

}  // namespace plumb::physics
