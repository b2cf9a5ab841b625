#include <algorithm>
#include <utility>

#include "core/fixed_list.hpp"
#include "physics/terrain/terrain_outlines.hpp"

namespace plumb::physics {

namespace {

/// Returns the edge along a part of a cell's side, clockwise.
TileEdge alongSide(GridPoint corner, CellSide side, FaceSpan span, EdgeKind kind) {
    if (side == kBottom || side == kLeft) std::swap(span.from, span.to);
    const auto at = [&](std::int32_t along) { return corner + alongFirst(side, {along, lineOf(side)}); };
    return {at(span.from), at(span.to), kind};
}

class EdgesOfCell {
public:
    EdgesOfCell(const TilePalette& palette, const CellWindow& window, std::vector<TileEdge>& edges)
        : palette_{palette}, edges_{edges}, toNeighbour_{-window.width(), 1, window.width(), -1} {}

    void append(const TileCell* number, GridPoint corner) {
        const MaskCell cell = maskCellOf(*number);
        if (cell.form == TileForm::Full && isInside(number)) return;
        const TileOutline& outline = palette_.outline(cell.form);
        const EdgeKind kind{cell.material, cell.layers, outline.oneWay, 0};
        for (const TileOutline::Edge& edge : outline.edges) {
            if (!edge.stops) continue;
            if (edge.side == kInside) {
                edges_.push_back({corner + edge.a, corner + edge.b, kind});
            } else {
                const std::int32_t from = alongFirst(edge.side, edge.a).x;
                const std::int32_t to = alongFirst(edge.side, edge.b).x;
                appendSide(corner, edge.side, {std::min(from, to), std::max(from, to)}, kind,
                           maskCellOf(number[toNeighbour_[edge.side]]));
            }
        }
    }

private:
    /// Fast path for the common case: a full cell among full cells with the same layers.
    [[nodiscard]] bool isInside(const TileCell* number) const {
        const std::uint8_t layers = maskCellOf(*number).layers;
        return std::all_of(std::begin(toNeighbour_), std::end(toNeighbour_), [&](std::ptrdiff_t step) {
            const MaskCell cell = maskCellOf(number[step]);
            return cell.form == TileForm::Full && cell.layers == layers;
        });
    }

    void appendSide(GridPoint corner, CellSide side, FaceSpan own, EdgeKind kind, MaskCell neighbour) {
        const std::vector<FaceSpan>& others =
            palette_.outline(neighbour.form).spans[static_cast<std::size_t>((side + 2) % 4)];
        FaceSpan open = own;  // the part that no span of the neighbour has covered yet
        for (const FaceSpan other : others) {
            const FaceSpan both = sharedPart(own, other);
            if (both.from > both.to) continue;
            // If the neighbour touches the side in one point, `both` is that point and splits the side.
            open.to = both.from;
            if (!open.empty()) edges_.push_back(alongSide(corner, side, open, kind));
            open = {both.to, own.to};
        }
        if (!open.empty()) edges_.push_back(alongSide(corner, side, open, kind));
        if (neighbour.layers == kind.layers || palette_.covers(neighbour.layers, kind.layers)) return;
        kind.behind = static_cast<std::uint8_t>(neighbour.layers + 1);
        for (const FaceSpan other : others) {
            const FaceSpan both = sharedPart(own, other);
            if (!both.empty()) edges_.push_back(alongSide(corner, side, both, kind));
        }
    }

    static FaceSpan sharedPart(FaceSpan a, FaceSpan b) {
        return {std::max(a.from, b.from), std::min(a.to, b.to)};
    }

    const TilePalette& palette_;
    std::vector<TileEdge>& edges_;
    std::ptrdiff_t toNeighbour_[4];
};

/// A clockwise rotation on screen: by less than 180 degrees, 180, more than 180, or 360.
enum class Turn : std::uint8_t { Less, Half, More, Full };

Turn turnOf(GridPoint from, GridPoint to) {
    const std::int64_t side = cross(from, to);
    if (side != 0) return side > 0 ? Turn::Less : Turn::More;
    return dot(from, to) < 0 ? Turn::Half : Turn::Full;
}

/// The edges that may follow an edge at one of its ends. At its end, a clockwise rotation from the reversed
/// edge sweeps the open side first. At its start the order is opposite; the coordinates are then mirrored, so
/// that both cases look the same.
class Vertex {
public:
    struct Candidate {
        std::uint32_t edge = kNone;
        GridPoint displacement;
        EdgeKind kind;
    };

    explicit Vertex(GridPoint back) : back_{back} {}

    /// Each of at most four cells at a point has at most TilePalette::kMaxTouching edges that start (or end)
    /// there.
    void add(const Candidate& candidate) {
        if (!candidates_.full()) candidates_.push(candidate);
    }

    /// The first wanted edge that a rotation through the open (or the solid) side reaches; kNone for none.
    template <class Wanted>
    [[nodiscard]] Candidate first(const Wanted& wanted, bool throughSolid = false) const {
        Candidate found;
        for (const Candidate& next : candidates_) {
            if (!wanted(next.kind)) continue;
            const bool earlier = throughSolid ? isEarlier(found, next) : isEarlier(next, found);
            if (found.edge == kNone || earlier) found = next;
        }
        return found;
    }
    template <class Wanted>
    [[nodiscard]] std::ptrdiff_t count(const Wanted& wanted) const {
        return std::count_if(candidates_.begin(), candidates_.end(),
                             [&](const Candidate& candidate) { return wanted(candidate.kind); });
    }
    [[nodiscard]] Turn turnTo(const Candidate& candidate) const {
        return turnOf(back_, candidate.displacement);
    }
    /// True if a clockwise rotation reaches `a` before `b`.
    [[nodiscard]] bool isEarlier(const Candidate& a, const Candidate& b) const {
        const Turn rotationA = turnTo(a), rotationB = turnTo(b);
        return rotationA != rotationB ? rotationA < rotationB : cross(a.displacement, b.displacement) > 0;
    }

private:
    GridPoint back_;  // the edge reversed: from its end to its start
    FixedList<Candidate, 4 * TilePalette::kMaxTouching> candidates_;
};

bool isPlain(EdgeKind kind) { return kind.isPlain(); }
bool isOneWay(EdgeKind kind) { return kind.oneWay != OneWay::No; }

/// Links of a plain edge. @param joined  true if solids that touch in this point count as one solid
EdgeLink linkOfPlain(const Vertex& vertex, bool joined) {
    const Vertex::Candidate outline = vertex.first(isPlain, !joined);
    if (vertex.turnTo(outline) != Turn::More) return {outline.edge, outline.edge};
    const Vertex::Candidate joint = vertex.first(isOneWay);
    const bool goesOn = joint.edge != kNone && vertex.isEarlier(joint, outline);
    return {outline.edge, goesOn ? joint.edge : outline.edge};
}

EdgeLink linkOfOneWay(const Vertex& vertex, OneWay side) {
    const Vertex::Candidate like = vertex.first([side](EdgeKind kind) { return kind.oneWay == side; });
    if (like.edge != kNone) return {like.edge, like.edge};
    const Vertex::Candidate solid = vertex.first(isPlain);
    const bool goesOn = solid.edge != kNone && vertex.turnTo(solid) <= Turn::Half;
    return {kNone, goesOn ? solid.edge : kNone};
}

EdgeLink linkOfInner(const Vertex& vertex, std::uint8_t layers) {
    const Vertex::Candidate own =
        vertex.first([layers](EdgeKind kind) { return kind.layers == layers && !isOneWay(kind); }, true);
    return {own.edge, own.edge};
}

}  // namespace

bool CellWindow::isUniform() const {
    if (cells_.empty()) return true;
    const TileForm form = maskCellOf(cells_.front()).form;
    if (form != TileForm::Empty && form != TileForm::Full) return false;
    return std::all_of(cells_.begin(), cells_.end(), [&](TileCell cell) { return cell == cells_.front(); });
}

void appendEdges(const TilePalette& palette, const CellWindow& window, CellRect rect,
                 std::vector<TileEdge>& edges) {
    EdgesOfCell cells{palette, window, edges};
    for (int y = rect.y0; y < rect.y1; ++y) {
        const TileCell* number = window.cell(rect.x0, y);
        for (int x = rect.x0; x < rect.x1; ++x, ++number) {
            if (maskCellOf(*number).form != TileForm::Empty) cells.append(number, cornerOfCell(x, y));
        }
    }
}

template <class Visit>
void EdgeLinks::forEdgesAt(GridPoint point, std::size_t end, const Visit& visit) const {
    for (std::uint32_t i = first_[end][bucketOf(point)]; i != kNone; i = next_[end][i]) {
        if ((*edges_)[i].end(end) == point) visit(i, (*edges_)[i]);
    }
}

void EdgeLinks::connect(const std::vector<TileEdge>& edges, CellRect cells) {
    edges_ = &edges;
    cells_ = cells;
    rowLength_ = static_cast<std::size_t>(cells.width()) + 1;
    for (std::size_t end = 0; end < 2; ++end) {
        first_[end].assign(rowLength_ * (static_cast<std::size_t>(cells.height()) + 1), kNone);
        next_[end].resize(edges.size());
        for (std::uint32_t i = 0; i < edges.size(); ++i)
            next_[end][i] = std::exchange(first_[end][bucketOf(edges[i].end(end))], i);
    }
}

/// True if all plain edges at a vertex have the same layers.
bool EdgeLinks::hasOneLayer(GridPoint point) const {
    int layers = -1;
    bool same = true;
    for (std::size_t end = 0; end < 2; ++end) {
        forEdgesAt(point, end, [&](std::uint32_t, const TileEdge& edge) {
            if (!edge.kind.isPlain()) return;
            same = same && (layers < 0 || layers == edge.kind.layers);
            layers = edge.kind.layers;
        });
    }
    return same;
}

EdgeLink EdgeLinks::find(std::uint32_t number, std::size_t end) const {
    const TileEdge& edge = (*edges_)[number];
    const GridPoint place = edge.end(end);
    const auto seen = [&](GridPoint far) {  // mirrored at the start of the edge
        return GridPoint{end == 0 ? place.x - far.x : far.x - place.x, far.y - place.y};
    };
    Vertex vertex{seen(edge.end(1 - end))};
    forEdgesAt(place, 1 - end, [&](std::uint32_t other, const TileEdge& candidate) {
        vertex.add({other, seen(candidate.end(end)), candidate.kind});
    });
    if (edge.kind.oneWay != OneWay::No) return linkOfOneWay(vertex, edge.kind.oneWay);
    if (edge.kind.isInner()) return linkOfInner(vertex, edge.kind.layers);
    return linkOfPlain(vertex, vertex.count(isPlain) == 1 || hasOneLayer(place));
}

}  // namespace plumb::physics
