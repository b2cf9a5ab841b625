#include "assets/tileset.hpp"

#include <algorithm>
#include <array>

namespace plumb {
namespace {

constexpr auto kShapeNames = std::to_array<std::string_view>(
    {"none", "full", "oneWay", "slopeUp", "slopeDown", "slopeUpLow", "slopeUpHigh", "slopeDownHigh",
     "slopeDownLow", "halfTop", "halfBottom"});

/// Returns the corners of a slope. `left` and `right` are the distances of its surface from the top, as
/// ratios of the tile's height.
std::vector<Vec2> slope(Vec2 size, float left, float right) {
    std::vector<Vec2> points;
    if (left < 1.0f) points.push_back({0.0f, left * size.y});
    if (right < 1.0f) points.push_back({size.x, right * size.y});
    points.push_back({size.x, size.y});
    points.push_back({0.0f, size.y});
    return points;
}

std::vector<Vec2> box(Vec2 size, float top, float bottom) {
    return {{0.0f, top * size.y}, {size.x, top * size.y}, {size.x, bottom * size.y}, {0.0f, bottom * size.y}};
}

}  // namespace

std::span<const std::string_view> tileShapeNames() { return kShapeNames; }

std::string_view Tile::property(std::string_view name) const {
    for (const TileProperty& property : properties) {
        if (property.name == name) return property.json;
    }
    return {};
}

const Tile* Tileset::find(int tile) const {
    const auto at =
        std::lower_bound(tiles.begin(), tiles.end(), tile, [](const Tile& a, int id) { return a.id < id; });
    return at != tiles.end() && at->id == tile ? &*at : nullptr;
}

TileShape Tileset::shapeOf(int tile) const {
    const Tile* special = find(tile);
    return special == nullptr ? TileShape::None : special->shape;
}

const TileImage* Tileset::imageOf(int tile) const {
    const auto at = std::lower_bound(images.begin(), images.end(), tile,
                                     [](const TileImage& a, int id) { return a.tile < id; });
    return at != images.end() && at->tile == tile ? &*at : nullptr;
}

namespace {

/// The tiles added when a tileset's image grew from size `from` to size `to`: columns on the right, then rows
/// below. Ids of older tiles do not change; indexOf() numbers the added ones.
struct Growth {
    TilesetSize from;
    TilesetSize to;

    [[nodiscard]] int right() const { return (to.columns - from.columns) * from.rows; }
    [[nodiscard]] int count() const { return right() + to.columns * (to.rows - from.rows); }
    [[nodiscard]] bool has(Tileset::Place at) const {
        return at.column < to.columns && at.row < to.rows &&
               (at.column >= from.columns || at.row >= from.rows);
    }
    [[nodiscard]] Tileset::Place placeOf(int index) const {
        const int wide = to.columns - from.columns;
        if (index < right()) return {from.columns + index % wide, index / wide};
        return {(index - right()) % to.columns, from.rows + (index - right()) / to.columns};
    }
    [[nodiscard]] int indexOf(Tileset::Place at) const {
        if (at.row < from.rows) return at.row * (to.columns - from.columns) + at.column - from.columns;
        return right() + (at.row - from.rows) * to.columns + at.column;
    }
};

}  // namespace

Tileset::Place Tileset::placeOf(int tile) const {
    const int wide = std::max(columns, 1);
    int first = sizes.empty() ? count : sizes.front().columns * sizes.front().rows;
    for (std::size_t i = 1; i < sizes.size() && tile >= first; ++i) {
        const Growth growth{sizes[i - 1], sizes[i]};
        if (tile - first < growth.count()) return growth.placeOf(tile - first);
        first += growth.count();
    }
    return {tile % wide, tile / wide};
}

int Tileset::tileAt(Place place) const {
    if (place.column < 0 || place.row < 0 || place.column >= currentColumns()) return -1;
    if (sizes.empty() || (place.column < sizes.front().columns && place.row < sizes.front().rows)) {
        const int tile = place.row * std::max(columns, 1) + place.column;
        return tile < count ? tile : -1;
    }
    int first = sizes.front().columns * sizes.front().rows;
    for (std::size_t i = 1; i < sizes.size(); ++i) {
        const Growth growth{sizes[i - 1], sizes[i]};
        if (growth.has(place)) return first + growth.indexOf(place);
        first += growth.count();
    }
    return -1;
}

int Tileset::growTo(int newColumns, int newRows) {
    const int wide = std::max(columns, 1);
    const TilesetSize now = sizes.empty() ? TilesetSize{wide, (count + wide - 1) / wide} : sizes.back();
    const TilesetSize next{std::max(newColumns, now.columns), std::max(newRows, now.rows)};
    const int before = count;
    if (next == now) return 0;
    if (next.columns == now.columns && sizes.empty()) {
        count = next.columns * next.rows;
        return count - before;
    }
    if (sizes.empty()) sizes.push_back(now), count = now.columns * now.rows;
    sizes.push_back(next);
    count += Growth{now, next}.count();
    return count - before;
}

Rect Tileset::sourceOf(int tile) const {
    const Place place = placeOf(tile);
    return {static_cast<float>(margin + place.column * (tileWidth + spacing)),
            static_cast<float>(margin + place.row * (tileHeight + spacing)), static_cast<float>(tileWidth),
            static_cast<float>(tileHeight)};
}

int Tileset::shownTile(int tile, double seconds) const {
    const Tile* special = find(tile);
    if (special == nullptr || special->animation.empty() || !(seconds >= 0.0) || seconds > 1e12) return tile;
    double total = 0.0;
    for (const TileFrame& frame : special->animation) total += static_cast<double>(frame.seconds);
    if (!(total > 0.0)) return tile;
    double rest = seconds - total * static_cast<double>(static_cast<long long>(seconds / total));
    for (const TileFrame& frame : special->animation) {
        rest -= static_cast<double>(frame.seconds);
        if (rest < 0.0) return frame.tile;
    }
    return special->animation.front().tile;
}

std::vector<std::vector<Vec2>> outlinesOf(const Tile& tile, Vec2 size) {
    switch (tile.shape) {
        case TileShape::None: return {};
        case TileShape::Full:
        case TileShape::OneWay: return {box(size, 0.0f, 1.0f)};
        case TileShape::SlopeUp: return {slope(size, 1.0f, 0.0f)};
        case TileShape::SlopeDown: return {slope(size, 0.0f, 1.0f)};
        case TileShape::SlopeUpLow: return {slope(size, 1.0f, 0.5f)};
        case TileShape::SlopeUpHigh: return {slope(size, 0.5f, 0.0f)};
        case TileShape::SlopeDownHigh: return {slope(size, 0.0f, 0.5f)};
        case TileShape::SlopeDownLow: return {slope(size, 0.5f, 1.0f)};
        case TileShape::HalfTop: return {box(size, 0.0f, 0.5f)};
        case TileShape::HalfBottom: return {box(size, 0.5f, 1.0f)};
        case TileShape::Polygon: return tile.polygons;
    }
    return {};
}

}  // namespace plumb
