#include "physics/terrain/tile_mask.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "physics/model/checks.hpp"

namespace plumb::physics {

namespace {

constexpr std::int32_t kSnap = kCellUnits / 256;  // units: corners this near to a border move onto it
constexpr std::size_t kMaxConvexCorners = 8;      // of addPolygon()

CellSide sideOf(GridPoint a, GridPoint b) {
    for (const CellSide side : {kTop, kRight, kBottom, kLeft}) {
        const std::int32_t line = lineOf(side);
        if (alongFirst(side, a).y == line && alongFirst(side, b).y == line) return side;
    }
    return kInside;
}

/// Returns the parts of a side that a solid outline fills, and the points at which it touches the side.
std::vector<FaceSpan> spansOf(const TileOutline& outline, CellSide side) {
    std::vector<FaceSpan> spans;
    if (!outline.isSolid()) return spans;
    for (const TileOutline::Edge& edge : outline.edges) {
        if (edge.side != side) continue;
        const std::int32_t from = alongFirst(side, edge.a).x, to = alongFirst(side, edge.b).x;
        spans.push_back({std::min(from, to), std::max(from, to)});
    }
    for (const TileOutline::Edge& edge : outline.edges) {
        const auto [along, across] = alongFirst(side, edge.a);
        const auto holds = [place = along](FaceSpan span) { return span.from <= place && place <= span.to; };
        if (across == lineOf(side) && std::none_of(spans.begin(), spans.end(), holds))
            spans.push_back({along, along});
    }
    std::sort(spans.begin(), spans.end(), [](FaceSpan a, FaceSpan b) { return a.from < b.from; });
    return spans;
}

/// Computes the members that follow from the ends of the edges and `oneWay`.
TileOutline completed(TileOutline outline) {
    for (TileOutline::Edge& edge : outline.edges) {
        const GridPoint outward{edge.b.y - edge.a.y, edge.a.x - edge.b.x};
        edge.stops = outline.isSolid() || dot(outward, directionOf(outline.oneWay)) > 0;
        edge.side = sideOf(edge.a, edge.b);
    }
    for (const CellSide side : {kTop, kRight, kBottom, kLeft})
        outline.spans[static_cast<std::size_t>(side)] = spansOf(outline, side);
    return outline;
}

std::int64_t doubleAreaOf(std::span<const GridPoint> points) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += cross(points[i], points[(i + 1) % points.size()]);
    return sum;
}

void dropNeedless(std::vector<GridPoint>& points) {
    for (std::size_t i = 0; i < points.size() && points.size() >= 3;) {
        const GridPoint before = points[(i + points.size() - 1) % points.size()];
        const GridPoint after = points[(i + 1) % points.size()];
        if (cross(points[i] - before, after - points[i]) == 0) {
            points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
            i = i > 0 ? i - 1 : 0;  // the corner before may be collinear now
        } else {
            ++i;
        }
    }
}

/// True if no corner lies outside any edge. False also for outlines that wind around twice.
bool isConvex(std::span<const GridPoint> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const GridPoint a = points[i];
        const GridPoint displacement = points[(i + 1) % points.size()] - a;
        if (!std::all_of(points.begin(), points.end(),
                         [&](GridPoint p) { return cross(displacement, p - a) >= 0; }))
            return false;
    }
    return true;
}

/// Returns the outline of corners in units, without edges if it is not convex. It starts at the topmost
/// corner (of several, the leftmost), so that forms of equal shape are equal.
TileOutline outlineFrom(std::vector<GridPoint> points, OneWay oneWay) {
    dropNeedless(points);
    if (doubleAreaOf(points) < 0) std::reverse(points.begin(), points.end());
    const bool good = points.size() >= 3 && points.size() <= kMaxConvexCorners && isConvex(points);
    if (!good || doubleAreaOf(points) == 0) return {};
    const auto isFirst = [](GridPoint a, GridPoint b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
    std::rotate(points.begin(), std::min_element(points.begin(), points.end(), isFirst), points.end());
    TileOutline outline;
    outline.oneWay = oneWay;
    for (std::size_t i = 0; i < points.size(); ++i)
        outline.edges.push_back({points[i], points[(i + 1) % points.size()]});
    return completed(std::move(outline));
}

/// Returns the outline of edges that boundaryOf() returned.
TileOutline outlineFrom(std::span<const GridEdge> edges, OneWay oneWay) {
    if (TileOutline convex = outlineFrom(ringOf(edges), oneWay); !convex.edges.empty()) return convex;
    TileOutline outline;
    for (const GridEdge& edge : edges) outline.edges.push_back({edge.a, edge.b});
    outline.oneWay = oneWay;
    return completed(std::move(outline));
}

/// Converts a fraction of the cell to units. @return -1 for a position outside the cell, or NaN
std::int32_t toUnits(float part) {
    if (!(part > -1.0f && part < 2.0f)) return -1;
    const auto units = static_cast<std::int32_t>(std::floor(part * static_cast<float>(kCellUnits) + 0.5f));
    if (units < -kSnap || units > kCellUnits + kSnap) return -1;
    if (units <= kSnap) return 0;
    return units >= kCellUnits - kSnap ? kCellUnits : units;
}

/// Converts corners to units. @error a corner is outside the cell or not a number
Result<std::vector<GridPoint>> toUnits(std::span<const Vec2> points) {
    std::vector<GridPoint> corners;
    corners.reserve(points.size());
    for (const Vec2 point : points) {
        const GridPoint corner{toUnits(point.x), toUnits(point.y)};
        if (corner.x < 0 || corner.y < 0)
            return Error{"TilePalette", "a corner is outside the cell or not a number",
                         "pass corners as fractions of the cell, 0 to 1"};
        corners.push_back(corner);
    }
    return corners;
}

/// Returns the index of a value in a list; appends it if it is new. @error the list has `maximum` values
template <class Index, class T>
Result<Index> indexIn(std::vector<T>& list, const T& value, std::size_t maximum, const char* what) {
    const auto known = std::find(list.begin(), list.end(), value);
    const auto index = static_cast<Index>(known - list.begin());
    if (known != list.end()) return index;
    if (list.size() >= maximum)
        return Error{"TilePalette", format("too many different {}", what), format("use at most {}", maximum)};
    list.push_back(value);
    return index;
}

GridPoint flippedPoint(GridPoint point, TileCell flips) {
    if ((flips & kTileFlipDiagonal) != 0) std::swap(point.x, point.y);
    if ((flips & kTileFlipX) != 0) point.x = kCellUnits - point.x;
    if ((flips & kTileFlipY) != 0) point.y = kCellUnits - point.y;
    return point;
}

}  // namespace

TileMask::TileMask(int width, int height)
    : cells_{std::clamp(width, 0, kMaxSide),
             std::clamp(height, 0, std::min(kMaxSide, kMaxCells / std::clamp(width, 1, kMaxSide)))} {}

bool TileMask::set(int x, int y, MaskCell cell) {
    PLUMB_ASSERT(knows(cell), "the form, material or layers of the cell are not in the palette");
    if (!cells_.has(x, y) || !knows(cell) || at(x, y) == cell) return false;
    cells_.set(x, y, numberOf(cell));
    return true;
}

void TileMask::putPlain(int column, int row, MaskCell cell) {
    PLUMB_ASSERT(knows(cell), "the form, material or layers of a cell are not in the palette");
    if (cell == MaskCell{} || !knows(cell)) return cells_.put(column, row, nullptr);
    auto known = std::find_if(plains_.begin(), plains_.end(),
                              [&](const auto& plain) { return plain->cells.front() == numberOf(cell); });
    if (known == plains_.end()) known = plains_.insert(known, TileGrid::filled(numberOf(cell)));
    cells_.put(column, row, *known);
}

void TileMask::putChunk(int column, int row, const Chunk& cells) {
    if (std::all_of(cells.begin(), cells.end(), [&](MaskCell cell) { return cell == cells.front(); }))
        return putPlain(column, row, cells.front());
    PLUMB_ASSERT(std::all_of(cells.begin(), cells.end(), [this](MaskCell cell) { return knows(cell); }),
                 "the form, material or layers of a cell are not in the palette");
    auto chunk = std::make_shared<TileGrid::Chunk>();
    std::transform(cells.begin(), cells.end(), chunk->cells.begin(), numberOf);
    cells_.put(column, row, std::move(chunk));
}

bool TileMask::isPlain(int column, int row) const {
    const TileGrid::Chunk* chunk = cells_.chunk(column, row);
    if (chunk == nullptr) return true;
    const bool isInner = column > 0 && row > 0 && column + 1 < width() / TileGrid::kChunkSide &&
                         row + 1 < height() / TileGrid::kChunkSide;
    if (!isInner || maskCellOf(chunk->cells.front()).form != TileForm::Full) return false;
    for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
            if (cells_.chunk(x, y) != chunk) return false;  // only uniform chunks are shared within a grid
        }
    }
    return true;
}

TilePalette::TilePalette() : forms_(1), materials_(1), layers_(1) {
    constexpr std::int32_t kOne = kCellUnits;
    constexpr std::int32_t kHalf = kCellUnits / 2;
    const auto put = [this](std::vector<GridPoint> points, OneWay oneWay = OneWay::No) {
        forms_.push_back(outlineFrom(std::move(points), oneWay));
    };
    // The forms, in the order of TileForm.
    put({{0, 0}, {kOne, 0}, {kOne, kOne}, {0, kOne}});
    put({{0, 0}, {kOne, 0}, {kOne, kOne}, {0, kOne}}, OneWay::Up);
    put({{kOne, 0}, {kOne, kOne}, {0, kOne}});
    put({{0, 0}, {kOne, kOne}, {0, kOne}});
    put({{kOne, kHalf}, {kOne, kOne}, {0, kOne}});
    put({{kOne, 0}, {kOne, kOne}, {0, kOne}, {0, kHalf}});
    put({{0, 0}, {kOne, kHalf}, {kOne, kOne}, {0, kOne}});
    put({{0, kHalf}, {kOne, kOne}, {0, kOne}});
    put({{0, 0}, {kOne, 0}, {kOne, kHalf}, {0, kHalf}});
    put({{0, kHalf}, {kOne, kHalf}, {kOne, kOne}, {0, kOne}});
    put({{0, 0}, {kHalf, 0}, {kHalf, kOne}, {0, kOne}});
    put({{kHalf, 0}, {kOne, 0}, {kOne, kOne}, {kHalf, kOne}});
}

Result<TileForm> TilePalette::add(const TileOutline& outline) {
    return indexIn<TileForm>(forms_, outline, kMaxForms, "tile forms");
}

Result<TileForm> TilePalette::addPolygon(std::span<const Vec2> points, OneWay oneWay) {
    const Result<std::vector<GridPoint>> corners =
        toUnits(points.first(std::min(points.size(), kMaxCorners)));
    if (!corners) return corners.error();
    const TileOutline outline = outlineFrom(*corners, oneWay);
    if (outline.edges.empty() || points.size() > kMaxCorners) {
        return Error{"TilePalette::addPolygon", "the points do not form a convex polygon of 3 to 8 corners",
                     "list the corners in order, without concave corners"};
    }
    return add(outline);
}

Result<TileForm> TilePalette::addPolygons(std::span<const std::vector<Vec2>> polygons, OneWay oneWay) {
    std::vector<std::vector<GridPoint>> all;
    std::size_t count = 0;
    for (const std::vector<Vec2>& polygon : polygons) {
        count += polygon.size();
        if (count > kMaxCorners)
            return Error{"TilePalette", format("a tile form has more than {} corners", kMaxCorners),
                         "draw its shapes with fewer corners"};
        Result<std::vector<GridPoint>> corners = toUnits(polygon);
        if (!corners) return corners.error();
        all.push_back(std::move(*corners));
    }
    if (all.size() == 1) {
        if (const TileOutline convex = outlineFrom(all.front(), oneWay); !convex.edges.empty())
            return add(convex);
    }
    const auto edges = boundaryOf(all);
    if (!edges)
        return Error{"TilePalette", "the outlines of a tile form cross each other in too many places",
                     "draw fewer shapes that do not cross"};
    if (edges->empty())
        return Error{"TilePalette", "the shapes of a tile form have no area", "draw them as areas"};
    if (mostFromOnePoint(*edges) > kMaxTouching)
        return Error{"TilePalette",
                     format("more than {} outlines of a tile form meet in one point", kMaxTouching),
                     "move the shapes of the tile apart"};
    return add(outlineFrom(*edges, oneWay));
}

Result<TileForm> TilePalette::flipped(TileForm form, TileCell flips) {
    PLUMB_ASSERT(hasForm(form), "the form is not in this palette");
    if (!hasForm(form) || form == TileForm::Empty || (flips & kTileFlips) == 0) return form;
    const TileOutline& outline = forms_[static_cast<std::size_t>(form)];
    const bool isMirrored = std::popcount(flips & kTileFlips) % 2 == 1;
    std::vector<GridEdge> edges;
    edges.reserve(outline.edges.size());
    for (const TileOutline::Edge& edge : outline.edges) {
        const GridPoint a = flippedPoint(edge.a, flips), b = flippedPoint(edge.b, flips);
        edges.push_back(isMirrored ? GridEdge{b, a} : GridEdge{a, b});
    }
    sortEdges(edges);
    return add(outlineFrom(edges, outline.oneWay));
}

Result<TileForm> TilePalette::withOneWay(TileForm form, OneWay oneWay) {
    PLUMB_ASSERT(hasForm(form), "the form is not in this palette");
    if (!hasForm(form) || form == TileForm::Empty) return form;
    TileOutline outline = forms_[static_cast<std::size_t>(form)];
    outline.oneWay = oneWay;
    return add(completed(outline));
}

Result<std::uint8_t> TilePalette::addMaterial(const TileMaterial& material) {
    const auto checked =
        firstOf(checkNumber("TileMaterial.friction", material.friction, 0.0, kRoughest),
                checkNumber("TileMaterial.bounciness", material.bounciness, 0.0, 1.0),
                checkNumber("TileMaterial.surfaceSpeed", material.surfaceSpeed, -kFastest, kFastest));
    if (!checked) return checked.error();
    return indexIn<std::uint8_t>(materials_, material, kMaxMaterials, "materials");
}

Result<std::uint8_t> TilePalette::addLayers(const TileLayers& layers) {
    return indexIn<std::uint8_t>(layers_, layers, kMaxLayers, "layers");
}

}  // namespace plumb::physics
