#include "import/isometric.hpp"

#include "core/limits.hpp"
#include "core/text.hpp"
#include "math/angle.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

using tiled::Layer;
using tiled::Object;
using tiled::Shape;

constexpr int kEllipseCorners = 24;
constexpr std::size_t kMaxFlatCells = std::size_t{1} << 25;  // maximum, sum over all layers of a map

/// Projects points of the isometric map's plane to screen coordinates, px.
class Projection {
public:
    explicit Projection(const tiled::Map& map)
        : width_{static_cast<double>(map.tileWidth)},
          height_{static_cast<double>(map.tileHeight)},
          originX_{static_cast<double>(map.height) * width_ * 0.5} {}

    /// @param isOffset  (x, y) is a difference of two points, so the origin is not added
    [[nodiscard]] Vec2 onScreen(double x, double y, bool isOffset = false) const {
        // In an isometric map, Tiled's unit on both axes is the tile height.
        const double column = x / height_;
        const double row = y / height_;
        return {static_cast<float>((column - row) * width_ * 0.5 + (isOffset ? 0.0 : originX_)),
                static_cast<float>((column + row) * height_ * 0.5)};
    }

private:
    double width_;
    double height_;
    double originX_;
};

/// Returns the number of half cells in the grid around a layer: (width + height - 1)^2, about 4 per cell of a
/// square layer, many more of a long one.
std::size_t flatCells(const Layer& layer) {
    const auto side = static_cast<std::size_t>(layer.width + layer.height - 1);
    return layer.cells.empty() ? 0 : side * side;
}

void flattenCells(Layer& layer, int mapHeight) {
    if (layer.cells.empty()) return;
    Layer old;
    old.x = layer.x, old.y = layer.y;
    old.width = layer.width, old.height = layer.height;
    old.cells = std::move(layer.cells);
    layer.width = layer.height = old.width + old.height - 1;
    // A tile's lower edge is at the lower corner of its diamond, one half cell below the diamond's first row.
    layer.x = old.x - (old.y + old.height - 1) + mapHeight - 1;
    layer.y = old.x + old.y + 1;
    layer.cells.assign(static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height), 0);
    for (int y = 0; y < old.height; ++y) {
        for (int x = 0; x < old.width; ++x) {
            const int column = x - y + old.height - 1;
            const int row = x + y;
            layer.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(layer.width) +
                        static_cast<std::size_t>(column)] =
                old.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(old.width) +
                          static_cast<std::size_t>(x)];
        }
    }
}

/// Returns the outline of a rectangle, ellipse or capsule in the map's plane, px from the object's position.
std::vector<Vec2> outlineOf(const Object& object) {
    const auto width = static_cast<float>(object.width);
    const auto height = static_cast<float>(object.height);
    if (object.shape == Shape::Rectangle) return {{0, 0}, {width, 0}, {width, height}, {0, height}};
    std::vector<Vec2> points;
    for (int i = 0; i < kEllipseCorners; ++i) {
        const float angle = kTau * static_cast<float>(i) / static_cast<float>(kEllipseCorners);
        points.push_back({width * 0.5f * (1.0f + cosine(angle)), height * 0.5f * (1.0f + sine(angle))});
    }
    return points;
}

void flattenObject(Object& object, const Projection& projection) {
    const bool hasArea = object.width > 0.0 && object.height > 0.0;
    const bool isArea =
        object.shape == Shape::Rectangle || object.shape == Shape::Ellipse || object.shape == Shape::Capsule;
    if (isArea && hasArea) {
        object.points = outlineOf(object);
        object.shape = Shape::Polygon;
        object.width = object.height = 0.0;
    }
    for (Vec2& point : object.points) point = projection.onScreen(point.x, point.y, true);
    const Vec2 place = projection.onScreen(object.x, object.y);
    object.x = place.x;
    object.y = place.y;
}

}  // namespace

tiled::Map isometricToOrthogonal(const tiled::Map& map, ImportReport& report) {
    tiled::Map flat = map;
    const Projection projection{map};
    std::size_t room = kMaxFlatCells;
    for (Layer& layer : flat.layers) {
        if (const std::size_t cells = flatCells(layer);
            cells > room || layer.width + layer.height > limits::kTileSide) {
            report.problems.push_back(
                {format("layer {}", layer.name),
                 format("not imported: {} x {} cells need a grid of {} half cells, too many", layer.width,
                        layer.height, cells),
                 "make the map smaller, or split it"});
            layer.cells.clear();
            layer.width = layer.height = 0;
        } else {
            room -= cells;
        }
        flattenCells(layer, map.height);
        for (Object& object : layer.objects) flattenObject(object, projection);
    }
    if (map.tileWidth % 2 != 0 || map.tileHeight % 2 != 0) {
        report.problems.push_back(
            {"map",
             format("the cells of {} x {} px cannot be halved to whole px", map.tileWidth, map.tileHeight),
             "use an even tile width and height in Tiled; the imported tiles are slightly too close"});
    }
    flat.tileWidth = std::max(map.tileWidth / 2, 1);
    flat.tileHeight = std::max(map.tileHeight / 2, 1);
    flat.width = flat.height = map.width + map.height;
    for (tiled::Tileset& tileset : flat.tilesets) {
        if (tileset.objectAlignment.empty() || tileset.objectAlignment == "unspecified")
            tileset.objectAlignment = "bottom";
    }
    report.note(
        "the map is isometric: its tiles were put in a grid of half cells; rectangles and ellipses became "
        "polygons");
    return flat;
}

}  // namespace plumb
