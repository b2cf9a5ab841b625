#pragma once

#include "import/import_report.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// Converts an isometric map to an orthogonal one that looks the same. Its tiles go to every other cell of a
/// grid of cells half as wide and high, so rows are drawn from back to front. Objects are moved to the
/// positions where Tiled draws them; rectangles and ellipses become polygons.
tiled::Map isometricToOrthogonal(const tiled::Map& map, ImportReport& report);

}  // namespace plumb
