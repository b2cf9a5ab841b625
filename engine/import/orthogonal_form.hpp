#pragma once

#include "import/import_report.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// Converts an isometric, staggered or hexagonal map to an orthogonal one that looks the same. Its tiles go
/// to the cells of a finer grid, see MapLattice. Objects of isometric maps are moved to the positions where
/// Tiled draws them; rectangles and ellipses become polygons.
tiled::Map orthogonalForm(const tiled::Map& map, ImportReport& report);

}  // namespace plumb
