#include "physics/terrain/terrain_outlines.hpp"

#include <algorithm>
#include <numeric>

#include "core/task_pool.hpp"

namespace plumb::physics {

namespace {

constexpr std::size_t kWorthSharing = 1024;  // chunks: fewer are built faster than another thread wakes
constexpr std::size_t kPart = 64;            // chunks that a thread takes at a time

bool touches(CellRect rect, GridPoint point) {
    const GridPoint low = cornerOfCell(rect.x0, rect.y0);
    const GridPoint high = cornerOfCell(rect.x1, rect.y1);
    return point.x >= low.x && point.y >= low.y && point.x <= high.x && point.y <= high.y;
}

/// Appends the edges of the ring of cells around `rect` that touch its border.
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
        ends_.emplace_back(first, edge);
        first = places_[edge].after.outline;
        if (!joinsNext(edge) || first == start) return;
    }
}

void OutlineBuilder::setGhosts(TerrainOutline& outline) const {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        TerrainSegment& segment = outline[i];
        const GridPoint along = segment.b - segment.a;
        const std::uint32_t before = places_[ends_[i].first].before.ghost;
        const std::uint32_t after = places_[ends_[i].second].after.ghost;
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
    places_.resize(own_);
    for (std::uint32_t i = 0; i < own_; ++i) places_[i] = {links_.before(i), links_.after(i)};
    ends_.clear();
    for (std::uint32_t i = 0; i < own_; ++i) {
        const std::uint32_t before = places_[i].before.outline;
        if (before >= own_ || !joinsNext(before) || places_[before].after.outline != i) walk(i, outline);
    }
    for (std::uint32_t i = 0; i < own_; ++i) {
        if (places_[i].segment == kNone && !isStraightAfter(places_[i].before.outline)) walk(i, outline);
    }
    setGhosts(outline);
}

TerrainOutlines::TerrainOutlines(TileMask mask, int chunkCells)
    : mask_{std::move(mask)},
      chunkCells_{std::clamp(chunkCells, 4, 128)},
      columns_{(mask_.width() + chunkCells_ - 1) / chunkCells_},
      rows_{(mask_.height() + chunkCells_ - 1) / chunkCells_} {
    chunks_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    isDirty_.assign(chunks_.size(), 1);
    dirty_.resize(chunks_.size());
    std::iota(dirty_.begin(), dirty_.end(), 0u);
}

void TerrainOutlines::set(int x, int y, MaskCell cell) {
    if (!mask_.set(x, y, cell)) return;
    for (int ny = y - 1; ny <= y + 1; ++ny) {
        for (int nx = x - 1; nx <= x + 1; ++nx) {
            if (!mask_.cells().has(nx, ny)) continue;
            const auto chunk = static_cast<std::uint32_t>(ny / chunkCells_ * columns_ + nx / chunkCells_);
            if (std::exchange(isDirty_[chunk], std::uint8_t{1}) == 0) dirty_.push_back(chunk);
        }
    }
}

bool TerrainOutlines::makeChunk(std::uint32_t chunk, Maker& maker) {
    const int column = static_cast<int>(chunk) % columns_, row = static_cast<int>(chunk) / columns_;
    if (chunkCells_ == kChunkCells && mask_.isPlain(column, row)) {
        maker.fresh.clear();
    } else {
        maker.builder.build(mask_, cellsOf(chunk), maker.fresh);
    }
    if (maker.fresh == chunks_[chunk]) return false;
    chunks_[chunk] = maker.fresh;  // a copy has no spare capacity, and both vectors keep their memory
    return true;
}

std::span<const std::uint32_t> TerrainOutlines::update(TaskPool* pool) {
    changed_.clear();
    std::sort(dirty_.begin(), dirty_.end());
    const auto make = [this](std::size_t first, std::size_t last, Maker& maker) {
        for (std::size_t i = first; i < last; ++i) isDirty_[dirty_[i]] = makeChunk(dirty_[i], maker) ? 1 : 0;
    };
    if (pool == nullptr || dirty_.size() < kWorthSharing) {
        make(0, dirty_.size(), makers_.front());
    } else {
        makers_.resize(std::max(makers_.size(), static_cast<std::size_t>(pool->threads())));
        const std::size_t parts = (dirty_.size() + kPart - 1) / kPart;
        pool->run(static_cast<int>(parts), [&](int part, int thread) {
            const std::size_t first = static_cast<std::size_t>(part) * kPart;
            make(first, std::min(first + kPart, dirty_.size()), makers_[static_cast<std::size_t>(thread)]);
        });
        makers_.resize(1);
    }
    for (const std::uint32_t chunk : dirty_) {
        if (std::exchange(isDirty_[chunk], std::uint8_t{0}) != 0) changed_.push_back(chunk);
    }
    dirty_.clear();
    return changed_;
}

}  // namespace plumb::physics
