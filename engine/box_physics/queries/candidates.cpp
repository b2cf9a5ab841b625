#include "box_physics/queries/candidates.hpp"

namespace plumb::box_physics {

void refreshFixedGrid(World& world) {
    Workspace& work = world.work;
    if (!work.fixedGridStale) return;
    work.gridded.clear();
    work.broad.clear();
    work.bounds.resize(world.bodies.size());
    for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
        if (world.bodies.kind[i] != BodyKind::Static) continue;
        work.bounds[i] = world.bodies.shape[i].boundsAt(world.bodies.position[i]);
        const bool tiles = world.bodies.shape[i].kind == ShapeKind::Tiles;
        (tiles ? work.broad : work.gridded).push_back(i);
    }
    const float size = cellSizeFor(work.gridded, work.bounds);
    work.fixedGrid.build(work.gridded, work.bounds, size, CellGrid::kMaxCellsPerBody, work.broad);
    work.fixedGridStale = false;
}

}  // namespace plumb::box_physics
