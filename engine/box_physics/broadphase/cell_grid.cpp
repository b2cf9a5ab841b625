#include "box_physics/broadphase/cell_grid.hpp"

#include <algorithm>

namespace plumb::box_physics {

void CellGrid::build(std::span<const std::uint32_t> bodies, std::span<const AABB> bounds, float cellSize,
                     int most, std::vector<std::uint32_t>& tooLarge) {
    size_ = cellSize;
    perSize_ = 1.0f / cellSize;
    unsorted_.clear();
    for (const std::uint32_t body : bodies) {
        const Cells cells = cellsOf(bounds[body]);
        if (cells.count() > most) {
            tooLarge.push_back(body);
            continue;
        }
        for (std::int32_t y = cells.minY; y <= cells.maxY; ++y) {
            for (std::int32_t x = cells.minX; x <= cells.maxX; ++x) {
                unsorted_.push_back({body, x, y});
            }
        }
    }
    unsigned bits = 6;
    while (bits < 22 && (std::size_t{1} << bits) < unsorted_.size()) ++bits;
    widthBits_ = (bits + 1) / 2;
    widthMask_ = (1u << widthBits_) - 1;
    heightMask_ = (1u << (bits - widthBits_)) - 1;

    // Counting sort by slot: entries of a slot keep the order of the bodies.
    // Counted two places on, so that the placing, which moves each start to its end, leaves them where they
    // belong.
    starts_.assign((std::size_t{1} << bits) + 2, 0);
    for (const Reached& reached : unsorted_) ++starts_[slotIndex(reached.x, reached.y) + 2];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    entries_.resize(unsorted_.size());
    for (const Reached& reached : unsorted_) {
        entries_[starts_[slotIndex(reached.x, reached.y) + 1]++] = {reached.body, reached.x, reached.y,
                                                                    bounds[reached.body]};
    }
}

float cellSizeFor(std::span<const std::uint32_t> bodies, std::span<const AABB> bounds) {
    double sum = 0.0;
    for (const std::uint32_t i : bodies) {
        const Vec2 size = bounds[i].size();
        sum += std::max(size.x, size.y);
    }
    const double usual = bodies.empty() ? 1.0 : 2.0 * sum / static_cast<double>(bodies.size());
    float size = 1.0f / 64.0f;
    while (size < usual && size < 65536.0f) size *= 2.0f;
    return size;
}

}  // namespace plumb::box_physics
