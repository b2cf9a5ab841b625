#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace plumb {

/// A point with whole coordinates.
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

/// An edge of an area. Seen from a to b with y down, the area is on the right.
struct GridEdge {
    GridPoint a;
    GridPoint b;

    friend constexpr bool operator==(const GridEdge&, const GridEdge&) = default;
};

/// Returns the edges between the inside and the outside of the union of polygons, without crossings, in an
/// order that depends on the area only. Each polygon may be concave, cross itself (inside is what a ray
/// leaves after an odd number of crossings) and have any winding. Crossings are rounded to whole coordinates.
/// @return nothing if the crossings cannot be rounded without new ones
std::optional<std::vector<GridEdge>> boundaryOf(std::span<const std::vector<GridPoint>> polygons);

/// Returns the largest number of edges that start at the same point.
std::ptrdiff_t mostFromOnePoint(std::span<const GridEdge> edges);

/// Sorts edges so that equal areas have equal lists.
void sortEdges(std::vector<GridEdge>& edges);

/// Returns the corners of edges that are a single closed outline; empty if they are not.
std::vector<GridPoint> ringOf(std::span<const GridEdge> edges);

}  // namespace plumb
