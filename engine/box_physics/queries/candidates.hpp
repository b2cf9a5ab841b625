#pragma once

#include "box_physics/world.hpp"

namespace plumb::box_physics {

/// Makes the grid of static bodies current; queries between steps see what was just made.
void refreshFixedGrid(World& world);

/// Calls `visit(index)` once for every static body whose bounds reach this box, in a fixed order.
/// @pre refreshFixedGrid, since the last change of a static body
template <class Visit>
void forEachFixed(const World& world, const AABB& box, Visit visit) {
    const Workspace& work = world.work;
    const auto reaches = [&](const AABB& other) {
        return box.max.x >= other.min.x && box.min.x <= other.max.x && box.max.y >= other.min.y &&
               box.min.y <= other.max.y;
    };
    for (const std::uint32_t i : work.broad) {
        if (reaches(work.bounds[i])) visit(i);
    }
    if (work.fixedGrid.empty()) return;
    const CellGrid::Cells cells = work.fixedGrid.cellsOf(box);
    if (cells.count() > static_cast<std::int64_t>(work.fixedGrid.slotCount())) {
        for (const std::uint32_t i : work.gridded) {
            if (reaches(work.bounds[i])) visit(i);
        }
        return;
    }
    for (std::int32_t y = cells.minY; y <= cells.maxY; ++y) {
        for (std::int32_t x = cells.minX; x <= cells.maxX; ++x) {
            for (const CellEntry& entry : work.fixedGrid.slotOf(x, y)) {
                const AABB& other = work.bounds[entry.body];
                if (entry.x != x || entry.y != y || !reaches(other)) continue;
                if (work.fixedGrid.isFirstShared(box, other, x, y)) visit(entry.body);
            }
        }
    }
}

}  // namespace plumb::box_physics
