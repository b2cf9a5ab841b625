#include "physics/terrain/outlines.hpp"

#include <algorithm>

namespace plumb::physics {

namespace {

bool touches(CellRect rect, GridPoint point) {
    const GridPoint low = cornerOfCell(rect.x0, rect.y0);
    const GridPoint high = cornerOfCell(rect.x1, rect.y1);
    return point.x >= low.x && point.y >= low.y && point.x <= high.x && point.y <= high.y;
}

/// Appends the edges of the cells around `rect` that end at its border. Which of their sides are open depends
/// on the same ring of cells.
void appendBorder(const TilePalette& palette, const CellWindow& window, CellRect rect,
                  std::vector<TileEdge>& edges) {
    const std::size_t own = edges.size();
    const CellRect ring = rect.grown(1);
    appendEdges(palette, window, {ring.x0, ring.y0, ring.x1, rect.y0}, edges);
    appendEdges(palette, window, {ring.x0, rect.y0, rect.x0, rect.y1}, edges);
    appendEdges(palette, window, {rect.x1, rect.y0, ring.x1, rect.y1}, edges);
    appendEdges(palette, window, {ring.x0, rect.y1, ring.x1, ring.y1}, edges);
    const auto isFar = [rect](const TileEdge& edge) {
        return !touches(rect, edge.a) && !touches(rect, edge.b);
    };
    edges.erase(std::remove_if(edges.begin() + static_cast<std::ptrdiff_t>(own), edges.end(), isFar),
                edges.end());
}

}  // namespace

Geometry geometryOf(const TerrainSegment& segment, Vec2 cellSize, GridPoint origin) {
    const auto place = [&](GridPoint point) { return toMetres(point, cellSize, origin); };
    return chainSegment(place(segment.before), place(segment.a), place(segment.b), place(segment.after));
}

void OutlineBuilder::findPlaces() {
    places_.resize(own_);
    for (std::uint32_t i = 0; i < own_; ++i) places_[i] = {links_.before(i), links_.after(i)};
}

/// True if the next edge belongs to the same chain.
bool OutlineBuilder::joinsNext(std::uint32_t edge) const {
    const std::uint32_t next = places_[edge].after.outline;
    return next < own_ && edges_[next].kind == edges_[edge].kind && places_[next].before.outline == edge;
}

/// True if the next edge belongs to the same segment.
bool OutlineBuilder::isStraightAfter(std::uint32_t edge) const {
    if (!joinsNext(edge)) return false;
    const TileEdge& next = edges_[places_[edge].after.outline];
    return cross(edges_[edge].b - edges_[edge].a, next.b - next.a) == 0;  // an outline never reverses
}

/// Appends the chain of segments that begins with an edge.
void OutlineBuilder::walk(std::uint32_t start, TerrainOutline& outline) {
    std::uint32_t first = start;
    for (std::uint32_t edge = start;; edge = places_[edge].after.outline) {
        places_[edge].segment = static_cast<std::uint32_t>(outline.size());
        if (isStraightAfter(edge)) continue;
        outline.push_back({edges_[first].a, edges_[edge].b, {}, {}, edges_[edge].kind});
        firstEdge_.push_back(first);
        lastEdge_.push_back(edge);
        first = places_[edge].after.outline;
        if (!joinsNext(edge) || first == start) return;
    }
}

void OutlineBuilder::setGhosts(TerrainOutline& outline) const {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        TerrainSegment& segment = outline[i];
        const GridPoint along = segment.b - segment.a;
        const std::uint32_t before = places_[firstEdge_[i]].before.ghost;
        const std::uint32_t after = places_[lastEdge_[i]].after.ghost;
        segment.before = before == kNone ? segment.a - along
                         : before < own_ ? outline[places_[before].segment].a
                                         : edges_[before].a;
        segment.after = after == kNone ? segment.b + along
                        : after < own_ ? outline[places_[after].segment].b
                                       : edges_[after].b;
    }
}

void OutlineBuilder::build(const TileMask& mask, CellRect rect, TerrainOutline& outline) {
    outline.clear();
    window_.read(mask, rect.grown(2));
    if (window_.isUniform()) return;
    edges_.clear();
    appendEdges(mask.palette, window_, rect, edges_);
    own_ = static_cast<std::uint32_t>(edges_.size());
    if (own_ == 0) return;
    appendBorder(mask.palette, window_, rect, edges_);
    links_.connect(edges_, rect.grown(2));
    findPlaces();
    firstEdge_.clear();
    lastEdge_.clear();
    for (std::uint32_t i = 0; i < own_; ++i) {
        const std::uint32_t before = places_[i].before.outline;
        if (before >= own_ || !joinsNext(before) || places_[before].after.outline != i) walk(i, outline);
    }
    for (std::uint32_t i = 0; i < own_; ++i) {
        if (places_[i].segment == kNone && !isStraightAfter(places_[i].before.outline)) walk(i, outline);
    }
    setGhosts(outline);
}

}  // namespace plumb::physics
