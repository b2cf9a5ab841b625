#include "physics/shapes/hull.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "physics/ranges.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

using Loop = std::vector<Vec2>;

/// Returns twice the signed area of a triangle: positive if a, b, c are in the direction of rotation from x
/// to y. In double precision products of differences of floats are exact, and so is the sign.
double areaOf(Vec2 a, Vec2 b, Vec2 c) { return cross(wide(b) - wide(a), wide(c) - wide(a)); }

/// Returns corner i of a loop, modulo its size.
Vec2 at(const Loop& loop, std::size_t i) { return loop[i % loop.size()]; }

/// Appends the lower part of the hull, or the upper part if the points are sorted in descending order.
void appendChain(std::span<const Vec2> sorted, Loop& loop) {
    const std::size_t start = loop.size();
    for (const Vec2 point : sorted) {
        while (loop.size() >= start + 2 && areaOf(loop[loop.size() - 2], loop.back(), point) <= 0.0)
            loop.pop_back();
        loop.push_back(point);
    }
    loop.pop_back();  // the other part begins with this corner
}

Loop loopAround(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    Loop loop;
    if (points.size() < 3) return loop;
    appendChain(points, loop);
    std::reverse(points.begin(), points.end());
    appendChain(points, loop);
    return loop;
}

/// Returns the distance (m) of `point` from the line through a and b; from a if a == b.
double heightOver(Vec2 a, Vec2 b, Vec2 point) {
    const Double2 side = wide(b) - wide(a);
    const double size = std::sqrt(dot(side, side));
    return size > 0.0 ? std::fabs(areaOf(a, b, point)) / size : static_cast<double>(distance(a, point));
}

/// Repeatedly removes the flattest corner while it protrudes by less than `height` (m).
void dropFlat(Loop& loop, double height) {
    while (loop.size() >= 3) {
        std::size_t flattest = 0;
        double minimum = height;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const double over = heightOver(at(loop, i + loop.size() - 1), at(loop, i + 1), loop[i]);
            if (over < minimum) {
                minimum = over;
                flattest = i;
            }
        }
        if (minimum >= height) return;
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(flattest));
    }
}

Vec2 normalOfFace(Vec2 from, Vec2 to) {
    const Double2 normal{wide(to).y - wide(from).y, wide(from).x - wide(to).x};
    const double size = std::sqrt(dot(normal, normal));
    return {static_cast<float>(normal.x / size), static_cast<float>(normal.y / size)};
}

/// Computes area and centroid, relative to the first corner for accuracy far from the origin.
void measure(Hull& hull) {
    const Vec2 origin = hull.corners[0].point;
    double twice = 0.0;
    Double2 sum;
    for (std::size_t i = 1; i + 1 < hull.corners.size(); ++i) {
        const Vec2 a = hull.corners[i].point, b = hull.corners[i + 1].point;
        const double part = areaOf(origin, a, b);
        twice += part;
        sum = sum + (wide(a - origin) + wide(b - origin)) * part;
    }
    hull.area = static_cast<float>(0.5 * twice);
    hull.centroid =
        origin + Vec2{static_cast<float>(sum.x / (3.0 * twice)), static_cast<float>(sum.y / (3.0 * twice))};
}

std::string text(Vec2 v) { return format("({}, {})", v.x, v.y); }

/// Returns the points without duplicates and without points in the middle of a straight side.
Loop cleaned(std::span<const Vec2> outline) {
    Loop loop;
    for (const Vec2 point : outline) {
        if (loop.empty() || !(loop.back() == point)) loop.push_back(point);
    }
    while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
    for (std::size_t i = 0; i < loop.size() && loop.size() > 3;) {
        const Vec2 before = at(loop, i + loop.size() - 1), after = at(loop, i + 1);
        const bool straight =
            areaOf(before, loop[i], after) == 0.0 && dot(after - loop[i], loop[i] - before) > 0.0f;
        if (straight) {
            loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
            i = i > 0 ? i - 1 : 0;
        } else {
            ++i;
        }
    }
    return loop;
}

bool isBetween(Vec2 a, Vec2 b, Vec2 point) {
    const Vec2 low = min(a, b), high = max(a, b);
    return low.x <= point.x && point.x <= high.x && low.y <= point.y && point.y <= high.y;
}

/// True if two sides cross or touch.
bool meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const double abc = areaOf(a, b, c), abd = areaOf(a, b, d);
    const double cda = areaOf(c, d, a), cdb = areaOf(c, d, b);
    if (abc * abd < 0.0 && cda * cdb < 0.0) return true;
    return (abc == 0.0 && isBetween(a, b, c)) || (abd == 0.0 && isBetween(a, b, d)) ||
           (cda == 0.0 && isBetween(c, d, a)) || (cdb == 0.0 && isBetween(c, d, b));
}

std::optional<Error> findCrossing(const Loop& loop) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = loop[i], b = at(loop, i + 1);
        if (areaOf(a, b, at(loop, i + 2)) == 0.0)
            return Error{"decompose", format("the outline turns back at {}", text(b)), "remove the spike"};
        for (std::size_t k = i + 2; k < n; ++k) {
            if (i == 0 && k == n - 1) continue;  // neighbours
            if (!meet(a, b, loop[k], at(loop, k + 1))) continue;
            return Error{"decompose",
                         format("the sides that start at {} and {} cross or touch", text(a), text(loop[k])),
                         "move a point, or split the outline"};
        }
    }
    return std::nullopt;
}

double twiceArea(const Loop& loop) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += areaOf(loop[0], loop[i], loop[i + 1]);
    return sum;
}

bool isEar(const Loop& loop, std::size_t i) {
    const Vec2 a = at(loop, i + loop.size() - 1), b = loop[i], c = at(loop, i + 1);
    if (areaOf(a, b, c) <= 0.0) return false;
    return std::none_of(loop.begin(), loop.end(), [&](Vec2 p) {
        if (p == a || p == b || p == c) return false;
        return areaOf(a, b, p) >= 0.0 && areaOf(b, c, p) >= 0.0 && areaOf(c, a, p) >= 0.0;
    });
}

/// Ear clipping. Skips a corner after each ear, so that not all triangles share one corner.
std::optional<std::vector<Loop>> triangles(Loop loop) {
    std::vector<Loop> pieces;
    std::size_t i = 0;
    std::size_t misses = 0;
    while (loop.size() > 3) {
        const std::size_t n = loop.size();
        i %= n;
        if (isEar(loop, i)) {
            pieces.push_back({at(loop, i + n - 1), loop[i], at(loop, i + 1)});
            loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
            misses = 0;
        } else if (++misses > n) {
            return std::nullopt;
        }
        ++i;
    }
    pieces.push_back(std::move(loop));
    return pieces;
}

/// Returns the union of two loops, if they share a side and the union is convex.
std::optional<Loop> joined(const Loop& a, const Loop& b) {
    if (a.size() + b.size() - 2 > kMaxCorners) return std::nullopt;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < b.size(); ++k) {
            if (!(b[k] == at(a, i + 1) && at(b, k + 1) == a[i])) continue;
            Loop whole;
            for (std::size_t m = 1; m <= a.size(); ++m) whole.push_back(at(a, i + m));
            for (std::size_t m = 2; m < b.size(); ++m) whole.push_back(at(b, k + m));
            for (std::size_t m = 0; m < whole.size(); ++m) {
                if (areaOf(whole[m], at(whole, m + 1), at(whole, m + 2)) < 0.0) return std::nullopt;
            }
            return whole;
        }
    }
    return std::nullopt;
}

void joinPieces(std::vector<Loop>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t k = i + 1; k < pieces.size();) {
            if (auto whole = joined(pieces[i], pieces[k])) {
                pieces[i] = std::move(*whole);
                pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
                k = i + 1;  // retries pieces that could not be joined before
            } else {
                ++k;
            }
        }
    }
}

}  // namespace

Result<Hull> makeHull(std::span<const Vec2> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 point = points[i];
        if (std::fabs(point.x) <= kLargest && std::fabs(point.y) <= kLargest) continue;
        return Error{"hull", format("point {} is {}, further than {} m", i, text(point), kLargest),
                     "use metres, not pixels, relative to the origin of the body"};
    }
    Loop loop = loopAround({points.begin(), points.end()});
    if (loop.size() < 3) {
        return Error{"hull", format("the {} points form no area", points.size()),
                     "pass at least 3 points that are not on one line"};
    }
    constexpr std::size_t kAbsurd = 4096;
    AABB box{loop[0], loop[0]};
    for (const Vec2 point : loop) box = merged(box, {point, point});
    const float size = std::max(box.size().x, box.size().y);
    if (!(size >= kSmallest))
        return Error{"hull", format("the hull is only {} m large", size), "make it at least 0.1 mm large"};
    if (loop.size() <= kAbsurd) dropFlat(loop, static_cast<double>(kBlur * size));
    if (loop.size() < 3)
        return Error{"hull", "the hull is too thin to have an area", "use a segment or a capsule"};
    if (loop.size() > kMaxCorners) {
        return Error{"hull", format("found {} corners, expected at most {}", loop.size(), kMaxCorners),
                     "remove points, use a circle, or decompose()"};
    }
    Hull hull;
    for (std::size_t i = 0; i < loop.size(); ++i)
        hull.corners.push({loop[i], normalOfFace(loop[i], at(loop, i + 1))});
    measure(hull);
    return hull;
}

Result<std::vector<Hull>> decompose(std::span<const Vec2> outline) {
    if (outline.size() > kMaxOutline) {
        return Error{"decompose", format("found {} points, expected at most {}", outline.size(), kMaxOutline),
                     "remove points"};
    }
    for (const Vec2 point : outline) {
        if (std::fabs(point.x) <= kLargest && std::fabs(point.y) <= kLargest) continue;
        return Error{"decompose", format("the point {} is further than {} m", text(point), kLargest),
                     "use metres, not pixels, relative to the origin of the body"};
    }
    Loop loop = cleaned(outline);
    if (loop.size() < 3)
        return Error{"decompose", "the outline has no area",
                     "pass at least 3 points that are not on one line"};
    if (auto crossing = findCrossing(loop)) return *crossing;
    const double area = 0.5 * twiceArea(loop);
    if (area < 0.0) std::reverse(loop.begin(), loop.end());

    auto pieces = triangles(std::move(loop));
    if (!pieces)
        return Error{"decompose", "the outline could not be triangulated",
                     "move points away from sides that they nearly touch"};
    joinPieces(*pieces);

    std::vector<Hull> hulls;
    for (const Loop& piece : *pieces) {
        auto hull = makeHull(piece);
        // A triangle that is too thin to be a shape may remain; its area is negligible.
        if (!hull && twiceArea(piece) > 1.0e-4 * std::fabs(area)) return hull.error();
        if (hull) hulls.push_back(*hull);
    }
    if (hulls.empty())
        return Error{"decompose", "the outline is too thin to have an area", "use segments or a capsule"};
    return hulls;
}

}  // namespace plumb::physics
