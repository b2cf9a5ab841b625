#include "physics/model/polygon_store.hpp"

#include <algorithm>
#include <bit>

namespace plumb::physics {

namespace {

/// Blocks of the pool have power-of-two sizes, so that a freed block fits other polygons.
int sizeClass(int corners) {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(corners, 4) - 1)));
}

}  // namespace

Geometry storePolygon(Shapes& shapes, const Hull& hull, float radius) {
    const int count = static_cast<int>(hull.corners.size());
    std::vector<std::uint32_t>& free = shapes.freeCorners[static_cast<std::size_t>(sizeClass(count))];
    auto first = static_cast<std::uint32_t>(shapes.corners.size());
    if (free.empty()) {
        shapes.corners.resize(shapes.corners.size() + (std::size_t{1} << sizeClass(count)));
    } else {
        first = free.back();
        free.pop_back();
    }
    std::copy(hull.corners.begin(), hull.corners.end(), shapes.corners.begin() + first);
    return polygon(hull, first, radius);
}

void freePolygon(Shapes& shapes, const Geometry& polygon) {
    shapes.freeCorners[static_cast<std::size_t>(sizeClass(polygon.count))].push_back(polygon.first);
}

}  // namespace plumb::physics
