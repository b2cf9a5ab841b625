#include "import/tile_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "import/isometric.hpp"
#include "math/angle.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

using tiled::Object;
using tiled::Shape;
using Corners = std::vector<Vec2>;

constexpr int kRoundCorners = 24;  // corners of an ellipse or capsule
constexpr float kSlack = 0.01f;    // tolerance of coordinates, px, and of areas, px^2
constexpr std::size_t kMaxBoxes = 32;

float doubleArea(const Corners& corners) {
    float area = 0.0f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 next = corners[(i + 1) % corners.size()];
        area += corners[i].x * next.y - next.x * corners[i].y;
    }
    return area;
}

/// Returns the outline of a box whose corners are rounded by quarter ellipses.
Corners roundBox(Vec2 size, Vec2 radius) {
    Corners corners;
    for (int i = 0; i < kRoundCorners; ++i) {
        const float angle = kTau * (static_cast<float>(i) + 0.5f) / static_cast<float>(kRoundCorners);
        const Vec2 unit{cosine(angle), sine(angle)};
        corners.push_back({(unit.x < 0.0f ? radius.x : size.x - radius.x) + unit.x * radius.x,
                           (unit.y < 0.0f ? radius.y : size.y - radius.y) + unit.y * radius.y});
    }
    return corners;
}

/// Clips a polygon at a vertical or horizontal line.
/// @param axis  coordinate that is compared with `limit`: &Vec2::x or &Vec2::y
/// @param sign  1 keeps the part below `limit`, -1 the part above it
Corners halfOf(const Corners& corners, float Vec2::*axis, float limit, float sign) {
    Corners kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = corners[i];
        const Vec2 to = corners[(i + 1) % corners.size()];
        const float before = sign * (limit - from.*axis);
        const float after = sign * (limit - to.*axis);
        if (before >= 0.0f) kept.push_back(from);
        if ((before > 0.0f && after < 0.0f) || (before < 0.0f && after > 0.0f))
            kept.push_back(from + (to - from) * (before / (before - after)));
    }
    return kept;
}

bool isInside(const Corners& corners, Vec2 cell) {
    return std::all_of(corners.begin(), corners.end(), [cell](Vec2 corner) {
        return corner.x >= -kSlack && corner.y >= -kSlack && corner.x <= cell.x + kSlack &&
               corner.y <= cell.y + kSlack;
    });
}

Corners cutToCell(Corners corners, Vec2 cell) {
    corners = halfOf(corners, &Vec2::x, 0.0f, -1.0f);
    corners = halfOf(corners, &Vec2::x, cell.x, 1.0f);
    corners = halfOf(corners, &Vec2::y, 0.0f, -1.0f);
    return halfOf(corners, &Vec2::y, cell.y, 1.0f);
}

/// Computes the outline of the union of boxes, on a grid of lines through all their edges.
class BoxOutline {
public:
    explicit BoxOutline(const std::vector<Corners>& boxes) {
        for (const Corners& box : boxes) {
            for (const Vec2 corner : box) xs_.push_back(corner.x), ys_.push_back(corner.y);
        }
        for (auto* lines : {&xs_, &ys_}) {
            std::sort(lines->begin(), lines->end());
            lines->erase(std::unique(lines->begin(), lines->end()), lines->end());
        }
        filled_.resize(xs_.size() * ys_.size());
        for (const Corners& box : boxes) fill(box);
    }

    /// @return the outline; empty if the boxes do not form one area, or it has a hole
    std::optional<Corners> trace() {
        collectEdges();
        if (next_.empty()) return {};
        Corners outline;
        const Node start = next_.begin()->first;
        std::size_t steps = 0;
        for (Node at = start; steps == 0 || at != start; ++steps) {
            const auto found = next_.find(at);
            if (found == next_.end() || steps > next_.size()) return {};
            outline.push_back({xs_[at.first], ys_[at.second]});
            at = found->second;
        }
        const bool all = steps == next_.size() && !crossing_;
        return all ? std::optional{withoutStraight(outline)} : std::nullopt;
    }

private:
    using Node = std::pair<std::size_t, std::size_t>;  // grid point: index in xs_ and in ys_

    static std::size_t lineOf(const std::vector<float>& lines, float value) {
        return static_cast<std::size_t>(std::lower_bound(lines.begin(), lines.end(), value) - lines.begin());
    }
    void fill(const Corners& box) {
        for (std::size_t y = lineOf(ys_, box[0].y); y < lineOf(ys_, box[2].y); ++y) {
            for (std::size_t x = lineOf(xs_, box[0].x); x < lineOf(xs_, box[2].x); ++x)
                filled_[y * xs_.size() + x] = true;
        }
    }
    /// True if a grid cell is in a box; false outside of the grid (index -1 wraps around to a large number).
    [[nodiscard]] bool isFilled(std::size_t x, std::size_t y) const {
        return x < xs_.size() && y < ys_.size() && filled_[y * xs_.size() + x];
    }
    /// Collects the edges between filled and empty cells, clockwise on screen.
    void collectEdges() {
        const auto add = [this](Node from, Node to) { crossing_ |= !next_.emplace(from, to).second; };
        for (std::size_t y = 0; y < ys_.size(); ++y) {
            for (std::size_t x = 0; x < xs_.size(); ++x) {
                if (!isFilled(x, y)) continue;
                if (!isFilled(x, y - 1)) add({x, y}, {x + 1, y});
                if (!isFilled(x + 1, y)) add({x + 1, y}, {x + 1, y + 1});
                if (!isFilled(x, y + 1)) add({x + 1, y + 1}, {x, y + 1});
                if (!isFilled(x - 1, y)) add({x, y + 1}, {x, y});
            }
        }
    }
    static Corners withoutStraight(const Corners& outline) {
        Corners corners;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2 before = outline[(i + outline.size() - 1) % outline.size()];
            const Vec2 after = outline[(i + 1) % outline.size()];
            const bool straight = before.x == after.x || before.y == after.y;
            if (!straight) corners.push_back(outline[i]);
        }
        return corners;
    }

    std::vector<float> xs_;
    std::vector<float> ys_;
    std::vector<bool> filled_;   // grid cells, row by row
    std::map<Node, Node> next_;  // edges of the outline: start to end
    bool crossing_ = false;      // two corners of the outline touch
};

/// Moves points from an object's own coordinates to those of its tile. @param raised  px, added to y
void place(Corners& corners, const Object& object, float raised) {
    const Vec2 origin{static_cast<float>(object.x), static_cast<float>(object.y) + raised};
    const float angle = radiansFromDegrees(static_cast<float>(object.rotation));
    for (Vec2& corner : corners) corner = origin + (angle == 0.0f ? corner : rotated(corner, angle));
}

bool isBox(const Object& object) { return object.shape == Shape::Rectangle && object.rotation == 0.0; }

}  // namespace

std::vector<Vec2> outlineOf(const Object& object) {
    const Vec2 size{static_cast<float>(object.width), static_cast<float>(object.height)};
    switch (object.shape) {
        case Shape::Polygon: return object.points;
        case Shape::Rectangle: return {{0.0f, 0.0f}, {size.x, 0.0f}, size, {0.0f, size.y}};
        case Shape::Ellipse: return roundBox(size, size * 0.5f);
        case Shape::Capsule: {
            const float radius = std::min(size.x, size.y) * 0.5f;
            return roundBox(size, {radius, radius});
        }
        case Shape::Polyline: {
            // A polyline whose ends coincide is a closed outline.
            const bool closed = object.points.size() > 3 && object.points.front() == object.points.back();
            return closed ? Corners{object.points.begin(), object.points.end() - 1} : Corners{};
        }
        case Shape::Point:
        case Shape::Text:
        case Shape::Tile: break;
    }
    return {};
}

std::vector<CollisionLine> collisionLinesOf(const tiled::Tile& tile, const tiled::Tileset& tileset,
                                            float imageHeight) {
    const bool isIsometric = tileset.isometricWidth > 0 && tileset.isometricHeight > 0;
    const IsometricPlane plane{tileset.isometricWidth, tileset.isometricHeight,
                               static_cast<double>(tileset.isometricWidth) * 0.5};
    std::vector<CollisionLine> lines;
    for (Object object : tile.collision) {
        if (isIsometric) {
            plane.project(object);
            object.y += static_cast<double>(imageHeight) - tileset.isometricHeight;
        }
        CollisionLine line{outlineOf(object)};
        line.closed = !line.points.empty();
        if (!line.closed && object.shape == Shape::Polyline) line.points = object.points;
        if (line.points.size() < (line.closed ? 3u : 2u) || line.points.size() > kMaxOutlineCorners) continue;
        place(line.points, object, 0.0f);
        if (line.closed && std::abs(doubleArea(line.points)) <= kSlack) continue;
        lines.push_back(std::move(line));
    }
    return lines;
}

TileOutline outlineOfTile(const tiled::Tile& tile, Vec2 cell, float raised) {
    TileOutline result;
    std::vector<Corners> shapes;
    bool boxes = true;
    for (const Object& object : tile.collision) {
        Corners corners = outlineOf(object);
        place(corners, object, raised);
        if (doubleArea(corners) < 0.0f) std::reverse(corners.begin(), corners.end());
        if (!isInside(corners, cell)) {
            corners = cutToCell(std::move(corners), cell);
            result.cut = true;
        }
        if (corners.size() < 3 || corners.size() > kMaxOutlineCorners || doubleArea(corners) <= kSlack)
            continue;
        boxes = boxes && isBox(object);
        shapes.push_back(std::move(corners));
    }
    if (shapes.empty()) return result;
    if (shapes.size() > 1 && boxes && shapes.size() <= kMaxBoxes) {
        if (std::optional<Corners> all = BoxOutline{shapes}.trace();
            all && all->size() <= kMaxOutlineCorners) {
            result.corners = std::move(*all);
            return result;
        }
    }
    result.partial = shapes.size() > 1;
    result.corners = *std::max_element(shapes.begin(), shapes.end(), [](const Corners& a, const Corners& b) {
        return doubleArea(a) < doubleArea(b);
    });
    return result;
}

}  // namespace plumb
