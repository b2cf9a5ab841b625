#include "physics/terrain/edge_links.hpp"

#include <iterator>

namespace plumb::physics {

namespace {

/// The angle from `from` to `to`, clockwise on screen: less than 180 degrees, 180, more, 360.
enum class Turn : std::uint8_t { Less, Half, More, Full };

Turn turnOf(GridPoint from, GridPoint to) {
    const std::int64_t side = cross(from, to);
    if (side != 0) return side > 0 ? Turn::Less : Turn::More;
    return dot(from, to) < 0 ? Turn::Half : Turn::Full;
}

/// True if a clockwise rotation that begins at `from` reaches `a` before `b`.
bool isEarlier(GridPoint from, GridPoint a, GridPoint b) {
    const Turn turnA = turnOf(from, a);
    const Turn turnB = turnOf(from, b);
    return turnA != turnB ? turnA < turnB : cross(a, b) > 0;
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

    /// Each of the four cells at a grid point has at most one edge there.
    void add(const Candidate& candidate) {
        if (count_ < std::size(candidates_)) candidates_[count_++] = candidate;
    }

    /// The first wanted edge when rotating through the open side; edge kNone if there is none.
    template <class Wanted>
    [[nodiscard]] Candidate first(const Wanted& wanted) const {
        return best(wanted, [this](GridPoint a, GridPoint b) { return isEarlier(back_, a, b); });
    }
    /// The first wanted edge when rotating through the solid side.
    template <class Wanted>
    [[nodiscard]] Candidate last(const Wanted& wanted) const {
        return best(wanted, [this](GridPoint a, GridPoint b) { return isEarlier(back_, b, a); });
    }
    template <class Wanted>
    [[nodiscard]] int count(const Wanted& wanted) const {
        int sum = 0;
        for (std::size_t i = 0; i < count_; ++i) sum += wanted(candidates_[i].kind) ? 1 : 0;
        return sum;
    }
    [[nodiscard]] Turn turnTo(const Candidate& candidate) const {
        return turnOf(back_, candidate.displacement);
    }
    [[nodiscard]] bool isEarlierThan(const Candidate& a, const Candidate& b) const {
        return isEarlier(back_, a.displacement, b.displacement);
    }

private:
    template <class Wanted, class Better>
    [[nodiscard]] Candidate best(const Wanted& wanted, const Better& better) const {
        const Candidate* found = nullptr;
        for (std::size_t i = 0; i < count_; ++i) {
            const Candidate& next = candidates_[i];
            if (wanted(next.kind) && (found == nullptr || better(next.displacement, found->displacement)))
                found = &next;
        }
        return found != nullptr ? *found : Candidate{};
    }

    GridPoint back_;
    Candidate candidates_[4];
    std::size_t count_ = 0;
};

bool isPlain(EdgeKind kind) { return kind.isPlain(); }
bool isOneWay(EdgeKind kind) { return kind.oneWay != OneWay::No; }

/// @param joined  solids that touch in this point count as one
EdgeLink linkOfPlain(const Vertex& vertex, bool joined) {
    const Vertex::Candidate outline =
        joined ? vertex.first(isPlain) : vertex.last(isPlain);
    if (vertex.turnTo(outline) != Turn::More) return {outline.edge, outline.edge};
    const Vertex::Candidate joint = vertex.first(isOneWay);
    const bool goesOn = joint.edge != kNone && vertex.isEarlierThan(joint, outline);
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
        vertex.last([layers](EdgeKind kind) { return kind.layers == layers && !isOneWay(kind); });
    return {own.edge, own.edge};
}

constexpr GridPoint mirroredIf(bool mirror, GridPoint displacement) {
    return mirror ? GridPoint{-displacement.x, displacement.y} : displacement;
}

}  // namespace

std::size_t EdgeLinks::bucketOf(GridPoint point) const {
    const GridPoint from = point - cornerOfCell(cells_.x0, cells_.y0);
    const auto row = static_cast<std::size_t>(from.y / kCellUnits);
    return row * rowLength_ + static_cast<std::size_t>(from.x / kCellUnits);
}

void EdgeLinks::connect(const std::vector<TileEdge>& edges, CellRect cells) {
    edges_ = &edges;
    cells_ = cells;
    rowLength_ = static_cast<std::size_t>(cells.width()) + 1;
    const std::size_t buckets = rowLength_ * (static_cast<std::size_t>(cells.height()) + 1);
    firstStart_.assign(buckets, kNone);
    firstEnd_.assign(buckets, kNone);
    nextStart_.resize(edges.size());
    nextEnd_.resize(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        std::uint32_t& start = firstStart_[bucketOf(edges[i].a)];
        std::uint32_t& end = firstEnd_[bucketOf(edges[i].b)];
        nextStart_[i] = start;
        nextEnd_[i] = end;
        start = end = static_cast<std::uint32_t>(i);
    }
}

/// True if all plain edges at a vertex have the same layers.
bool EdgeLinks::hasOneLayer(GridPoint place) const {
    int layers = -1;
    const auto agrees = [&](const TileEdge& edge, GridPoint end) {
        if (end != place || !edge.kind.isPlain()) return true;
        const bool same = layers < 0 || layers == edge.kind.layers;
        layers = edge.kind.layers;
        return same;
    };
    const std::vector<TileEdge>& edges = *edges_;
    const std::size_t bucket = bucketOf(place);
    for (std::uint32_t i = firstStart_[bucket]; i != kNone; i = nextStart_[i]) {
        if (!agrees(edges[i], edges[i].a)) return false;
    }
    for (std::uint32_t i = firstEnd_[bucket]; i != kNone; i = nextEnd_[i]) {
        if (!agrees(edges[i], edges[i].b)) return false;
    }
    return true;
}

EdgeLink EdgeLinks::find(std::uint32_t number, bool after) const {
    const std::vector<TileEdge>& edges = *edges_;
    const TileEdge& edge = edges[number];
    const GridPoint place = after ? edge.b : edge.a;
    Vertex vertex{mirroredIf(!after, (after ? edge.a : edge.b) - place)};
    const std::vector<std::uint32_t>& next = after ? nextStart_ : nextEnd_;
    std::uint32_t other = (after ? firstStart_ : firstEnd_)[bucketOf(place)];
    for (; other != kNone; other = next[other]) {
        const TileEdge& candidate = edges[other];
        if ((after ? candidate.a : candidate.b) != place) continue;
        vertex.add({other, mirroredIf(!after, (after ? candidate.b : candidate.a) - place), candidate.kind});
    }
    if (edge.kind.oneWay != OneWay::No) return linkOfOneWay(vertex, edge.kind.oneWay);
    if (edge.kind.isInner()) return linkOfInner(vertex, edge.kind.layers);
    return linkOfPlain(vertex, vertex.count(isPlain) == 1 || hasOneLayer(place));
}

}  // namespace plumb::physics
