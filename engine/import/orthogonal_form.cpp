#include "import/orthogonal_form.hpp"

#include <utility>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "import/isometric.hpp"
#include "import/map_lattice.hpp"

namespace plumb {
namespace {

using tiled::Gid;
using tiled::Layer;
using tiled::Orientation;

constexpr std::size_t kMaxFlatCells = std::size_t{1} << 25;  // maximum, sum over all layers of a map

std::size_t placeIn(int width, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

/// Converts the layers of a map, one after another.
class LayerFlattener {
public:
    LayerFlattener(const tiled::Map& map, ImportReport& report) : lattice_{map}, report_{report} {}

    void flatten(Layer& layer) {
        if (layer.cells.empty()) return;
        // About 4 cells for each cell of a square isometric layer, many more of a long one; 2 in other maps.
        const MapLattice::Area area = lattice_.areaOf(layer.x, layer.y, layer.width, layer.height);
        const bool fits = area.width <= limits::kTileSide && area.height <= limits::kTileSide;
        const std::size_t cells =
            static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height);
        if (!fits || cells > room_) return leaveOut(layer, cells);
        room_ -= cells;
        std::vector<Gid> old = std::exchange(layer.cells, std::vector<Gid>(cells, 0));
        for (int y = 0; y < layer.height; ++y) {
            for (int x = 0; x < layer.width; ++x) {
                const MapLattice::Cell cell = lattice_.cellOf(layer.x + x, layer.y + y);
                layer.cells[placeIn(area.width, cell.column - area.first.column, cell.row - area.first.row)] =
                    old[placeIn(layer.width, x, y)];
            }
        }
        layer.x = area.first.column;
        layer.y = area.first.row;
        layer.width = area.width;
        layer.height = area.height;
        layer.offset.y += static_cast<float>(lattice_.drop());
    }

private:
    void leaveOut(Layer& layer, std::size_t cells) {
        report_.problems.push_back(
            {format("layer {}", layer.name),
             format("not imported: {} x {} cells need a grid of {} half cells, too many", layer.width,
                    layer.height, cells),
             "make the map smaller, or split it"});
        layer.cells.clear();
        layer.width = layer.height = 0;
    }

    MapLattice lattice_;
    ImportReport& report_;
    std::size_t room_ = kMaxFlatCells;
};

void flattenObjects(const tiled::Map& map, tiled::Map& flat, ImportReport& report) {
    const IsometricPlane plane = IsometricPlane::of(map);
    for (Layer& layer : flat.layers) {
        for (tiled::Object& object : layer.objects) plane.project(object);
    }
    for (tiled::Tileset& tileset : flat.tilesets) {
        if (tileset.objectAlignment.empty() || tileset.objectAlignment == "unspecified")
            tileset.objectAlignment = "bottom";
    }
    report.note("in the isometric map rectangles and ellipses became polygons");
    if (map.tileWidth % 2 == 0 && map.tileHeight % 2 == 0) return;
    report.problems.push_back(
        {"map", format("the cells of {} x {} px cannot be halved to whole px", map.tileWidth, map.tileHeight),
         "use an even tile width and height in Tiled; the imported tiles are slightly too close"});
}

}  // namespace

tiled::Map orthogonalForm(const tiled::Map& map, ImportReport& report) {
    tiled::Map flat = map;
    LayerFlattener flattener{map, report};
    for (Layer& layer : flat.layers) flattener.flatten(layer);
    if (map.orientation == Orientation::Isometric) flattenObjects(map, flat, report);

    const MapLattice lattice{map};
    const MapLattice::Area area = lattice.areaOf(0, 0, map.width, map.height);
    flat.orientation = Orientation::Orthogonal;
    flat.width = area.width;
    flat.height = area.height;
    flat.tileWidth = lattice.cellWidth();
    flat.tileHeight = lattice.cellHeight();
    flat.wholeWidth = map.tileWidth;
    flat.wholeHeight = map.tileHeight;
    report.note(
        format("the map is {}: its tiles were put in a finer grid, in which every other cell stays empty",
               tiled::nameOf(map.orientation)));
    return flat;
}

}  // namespace plumb
