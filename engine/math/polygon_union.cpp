#include "math/polygon_union.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace plumb {

namespace {

using Edge = GridEdge;

constexpr int kMaxRounds = 32;              // rounding a crossing moves edges, which may then cross others
constexpr std::size_t kMaxParts = 1 << 13;  // of all edges; the time grows with its square

/// A part of a polygon's edge. After splitting, two parts are either equal or share at most their ends.
struct Part {
    GridPoint a;
    GridPoint b;
    std::size_t polygon = 0;
};

bool comesBefore(GridPoint a, GridPoint b) { return std::pair{a.y, a.x} < std::pair{b.y, b.x}; }

/// True if a point lies on a part, but is not one of its ends.
bool isWithin(const Part& part, GridPoint point) {
    const GridPoint along = part.b - part.a;
    const GridPoint to = point - part.a;
    return cross(along, to) == 0 && dot(along, to) > 0 && dot(along, to) < dot(along, along);
}

/// Divides, rounded to the nearest whole number; halves up. @pre divisor > 0
std::int64_t roundedQuotient(std::int64_t dividend, std::int64_t divisor) {
    const std::int64_t doubled = 2 * dividend + divisor;
    const std::int64_t quotient = doubled / (2 * divisor);
    return doubled % (2 * divisor) < 0 ? quotient - 1 : quotient;
}

/// Splits the edges of polygons where they meet.
class Splitter {
public:
    explicit Splitter(std::vector<Part> parts) : parts_{std::move(parts)} {}

    /// @return false if it does not end
    bool run() {
        for (int round = 0; round < kMaxRounds && parts_.size() <= kMaxParts; ++round) {
            cuts_.assign(parts_.size(), {});
            bool any = false;
            for (std::size_t i = 0; i < parts_.size(); ++i) {
                for (std::size_t k = i + 1; k < parts_.size(); ++k) any = meet(i, k) || any;
            }
            if (!any) return true;
            split();
        }
        return false;
    }
    [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

private:
    bool cut(std::size_t i, GridPoint point) {
        if (point == parts_[i].a || point == parts_[i].b) return false;
        cuts_[i].push_back(point);
        return true;
    }

    bool meet(std::size_t i, std::size_t k) {
        const Part& one = parts_[i];
        const Part& two = parts_[k];
        bool any = false;
        for (const GridPoint end : {two.a, two.b}) any = (isWithin(one, end) && cut(i, end)) || any;
        for (const GridPoint end : {one.a, one.b}) any = (isWithin(two, end) && cut(k, end)) || any;
        const GridPoint along = one.b - one.a;
        const GridPoint other = two.b - two.a;
        const std::int64_t before = cross(along, two.a - one.a), after = cross(along, two.b - one.a);
        const std::int64_t first = cross(other, one.a - two.a), last = cross(other, one.b - two.a);
        const bool isCrossing = (before < 0) != (after < 0) && before != 0 && after != 0 &&
                                (first < 0) != (last < 0) && first != 0 && last != 0;
        if (!isCrossing) return any;
        const std::int64_t whole = std::abs(first - last), part = std::abs(first);
        const GridPoint point{one.a.x + static_cast<std::int32_t>(roundedQuotient(part * along.x, whole)),
                              one.a.y + static_cast<std::int32_t>(roundedQuotient(part * along.y, whole))};
        any = cut(i, point) || any;
        return cut(k, point) || any;
    }

    void split() {
        std::vector<Part> smaller;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Part part = parts_[i];
            std::vector<GridPoint>& cuts = cuts_[i];
            std::sort(cuts.begin(), cuts.end(), [&](GridPoint p, GridPoint q) {
                return dot(part.b - part.a, p - part.a) < dot(part.b - part.a, q - part.a);
            });
            cuts.push_back(part.b);
            GridPoint from = part.a;
            for (const GridPoint to : cuts) {
                if (from != to) smaller.push_back({from, to, part.polygon});
                from = to;
            }
        }
        parts_ = std::move(smaller);
    }

    std::vector<Part> parts_;
    std::vector<std::vector<GridPoint>> cuts_;  // per part
};

GridPoint swapped(GridPoint point) { return {point.y, point.x}; }

/// Tells whether the two sides of parts are inside of any polygon.
class SideFinder {
public:
    SideFinder(const std::vector<Part>& parts, std::size_t polygons) : parts_{parts}, odd_(polygons) {}

    /// Returns the part, turned so that the inside is on its right on screen; of equal ends if both sides are
    /// inside or outside.
    Edge boundaryAt(const Part& part) {
        // A ray from the middle to larger x, or to larger y from a horizontal part.
        const bool isFlat = part.a.y == part.b.y;
        const bool isNearInside = isInside(part, isFlat, true);
        if (isNearInside == isInside(part, isFlat, false)) return {part.a, part.a};
        const bool goesUp = isFlat ? part.b.x > part.a.x : part.b.y > part.a.y;
        const bool isRightNear = isFlat != goesUp;  // the near side is left of a flat part towards larger x
        return isNearInside == isRightNear ? Edge{part.a, part.b} : Edge{part.b, part.a};
    }

private:
    /// @param isFlat  mirror x and y
    /// @param isNear  the side with the smaller coordinate, from where a ray crosses the part itself
    bool isInside(const Part& part, bool isFlat, bool isNear) {
        odd_.assign(odd_.size(), 0);
        const auto seen = [isFlat](GridPoint point) { return isFlat ? swapped(point) : point; };
        const GridPoint doubleMiddle = seen(part.a) + seen(part.b);
        for (const Part& other : parts_) {
            GridPoint low = seen(other.a), high = seen(other.b);
            if (low.y > high.y) std::swap(low, high);
            if (2 * low.y > doubleMiddle.y || 2 * high.y <= doubleMiddle.y) continue;
            const GridPoint to = doubleMiddle - low - low;
            const std::int64_t side = cross(high - low, to);  // positive: the middle is at smaller x
            if (side > 0 || (side == 0 && isNear)) odd_[other.polygon] ^= 1;
        }
        return std::find(odd_.begin(), odd_.end(), 1) != odd_.end();
    }

    const std::vector<Part>& parts_;
    std::vector<char> odd_;  // per polygon: 1 if the number of crossings is odd
};

std::ptrdiff_t countFrom(std::span<const Edge> edges, GridPoint point) {
    return std::count_if(edges.begin(), edges.end(), [point](const Edge& edge) { return edge.a == point; });
}

/// Joins edges that continue each other in a straight line.
void joinStraight(std::vector<Edge>& edges) {
    for (std::size_t i = 0; i < edges.size();) {
        const auto next =
            std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) { return edge.a == edges[i].b; });
        const GridPoint along = edges[i].b - edges[i].a;
        const bool joins = next != edges.end() && cross(along, next->b - next->a) == 0 &&
                           dot(along, next->b - next->a) > 0 && countFrom(edges, edges[i].b) == 1;
        if (!joins) {
            ++i;
            continue;
        }
        const auto removed = static_cast<std::size_t>(next - edges.begin());
        edges[i].b = next->b;
        edges.erase(next);
        if (removed < i) --i;
    }
}

}  // namespace

std::optional<std::vector<Edge>> boundaryOf(std::span<const std::vector<GridPoint>> polygons) {
    std::vector<Part> parts;
    for (std::size_t p = 0; p < polygons.size(); ++p) {
        for (std::size_t i = 0; i < polygons[p].size(); ++i) {
            const Part part{polygons[p][i], polygons[p][(i + 1) % polygons[p].size()], p};
            if (part.a != part.b) parts.push_back(part);
        }
    }
    Splitter splitter{std::move(parts)};
    if (!splitter.run()) return std::nullopt;
    SideFinder sides{splitter.parts(), polygons.size()};
    std::vector<Edge> edges;
    for (const Part& part : splitter.parts()) {
        if (const Edge edge = sides.boundaryAt(part); edge.a != edge.b) edges.push_back(edge);
    }
    sortEdges(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());  // several polygons have it
    joinStraight(edges);
    sortEdges(edges);
    return edges;
}

std::ptrdiff_t mostFromOnePoint(std::span<const Edge> edges) {
    std::ptrdiff_t most = 0;
    for (const Edge& edge : edges) most = std::max(most, countFrom(edges, edge.a));
    return most;
}

void sortEdges(std::vector<Edge>& edges) {
    std::sort(edges.begin(), edges.end(), [](const Edge& one, const Edge& two) {
        return one.a != two.a ? comesBefore(one.a, two.a) : comesBefore(one.b, two.b);
    });
}

std::vector<GridPoint> ringOf(std::span<const Edge> edges) {
    std::vector<GridPoint> ring;
    for (const Edge* at = edges.data(); !edges.empty();) {
        ring.push_back(at->a);
        if (at->b == edges.front().a) break;
        const auto next =
            std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) { return edge.a == at->b; });
        if (next == edges.end() || ring.size() > edges.size()) return {};
        at = &*next;
    }
    return ring.size() == edges.size() ? ring : std::vector<GridPoint>{};
}

}  // namespace plumb
