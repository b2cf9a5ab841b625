#pragma once

#include "import/import_report.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// An isometric map as an orthogonal one that looks the same: its diamonds stand in a grid of cells half as
/// wide and high, every other of which is empty, so that rows are drawn from the back to the front. Objects
/// come to stand where Tiled shows them; rectangles and ellipses become the polygons that they look like.
tiled::Map flattened(const tiled::Map& map, ImportReport& report);

}  // namespace plumb
