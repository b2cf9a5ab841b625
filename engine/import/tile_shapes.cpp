#include "import/tile_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "import/isometric.hpp"
#include "math/angle.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

using tiled::Object;
using tiled::Shape;
using Corners = std::vector<Vec2>;

constexpr int kRoundCorners = 24;          // corners of an ellipse or capsule
constexpr float kSlack = 0.01f;            // tolerance of coordinates, px, and of areas, px^2
constexpr float kLinePart = 1.0f / 64.0f;  // half of the thickness of a line, of the side of a cell

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

/// Moves points from an object's own coordinates to those of its tile. @param raised  px, added to y
void place(Corners& corners, const Object& object, float raised) {
    const Vec2 origin{static_cast<float>(object.x), static_cast<float>(object.y) + raised};
    const float angle = radiansFromDegrees(static_cast<float>(object.rotation));
    for (Vec2& corner : corners) corner = origin + (angle == 0.0f ? corner : rotated(corner, angle));
}

/// Returns a polyline as a thin area: a box around each of its lines.
/// @param half  half of the thickness, px
std::vector<Corners> thickened(const Corners& points, float half) {
    std::vector<Corners> boxes;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 way = points[i + 1] - points[i];
        if (lengthSquared(way) <= kSlack * kSlack) continue;
        const Vec2 along = way * (half / length(way));  // boxes overlap at the joints
        const Vec2 across{-along.y, along.x};
        const Vec2 from = points[i] - along, to = points[i + 1] + along;
        boxes.push_back({from - across, to - across, to + across, from + across});
    }
    return boxes;
}

/// Collects the area of the collision shapes of a tile.
class AreaCollector {
public:
    AreaCollector(Vec2 cell, float raised) : cell_{cell}, raised_{raised} {}

    void add(const Object& object) {
        Corners points = outlineOf(object);
        const bool isLine = points.empty() && object.shape == Shape::Polyline;
        if (isLine) points = object.points;
        place(points, object, raised_);
        const std::size_t before = area_.polygons.size();
        const float half = std::max(cell_.x, cell_.y) * kLinePart;
        if (!isLine) {
            addInside(points);
        } else {
            for (const Corners& box : thickened(points, half)) addInside(box);
        }
        if (area_.polygons.size() == before) {
            area_.refusals.push_back({&object, "it has neither area nor length in the cell"});
        } else if (!isInside(points, cell_)) {
            area_.refusals.push_back({&object, "it reaches out of the cell; it was clipped"});
        }
    }
    [[nodiscard]] TileArea take() { return std::move(area_); }

private:
    void addInside(Corners corners) {
        if (!isInside(corners, cell_)) corners = cutToCell(std::move(corners), cell_);
        const auto [low, high] = std::minmax_element(corners.begin(), corners.end(),
                                                     [](Vec2 one, Vec2 two) { return one.x < two.x; });
        const auto [top, bottom] = std::minmax_element(corners.begin(), corners.end(),
                                                       [](Vec2 one, Vec2 two) { return one.y < two.y; });
        if (corners.size() < 3 || high->x - low->x <= kSlack || bottom->y - top->y <= kSlack) return;
        area_.polygons.push_back(std::move(corners));
    }

    Vec2 cell_;
    float raised_;
    TileArea area_;
};

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

std::string_view nameOf(Shape shape) {
    constexpr std::string_view kNames[] = {"rectangle", "ellipse",  "point", "capsule",
                                           "polygon",   "polyline", "text",  "tile"};
    return kNames[static_cast<std::size_t>(shape)];
}

std::vector<CollisionLine> collisionLinesOf(const tiled::Tile& tile, const tiled::Tileset& tileset,
                                            float imageHeight, std::vector<ShapeRefusal>* refusals) {
    const bool isIsometric = tileset.isometricWidth > 0 && tileset.isometricHeight > 0;
    const IsometricPlane plane{tileset.isometricWidth, tileset.isometricHeight,
                               static_cast<double>(tileset.isometricWidth) * 0.5};
    std::vector<CollisionLine> lines;
    for (const Object& original : tile.collision) {
        const auto refuse = [&](std::string what) {
            if (refusals != nullptr) refusals->push_back({&original, std::move(what)});
        };
        Object object = original;
        if (isIsometric) {
            plane.project(object);
            object.y += static_cast<double>(imageHeight) - tileset.isometricHeight;
        }
        CollisionLine line{outlineOf(object)};
        line.closed = !line.points.empty();
        if (!line.closed && object.shape == Shape::Polyline) line.points = object.points;
        if (line.points.size() > kMaxOutlineCorners) {
            refuse(format("it has more than {} corners", kMaxOutlineCorners));
            continue;
        }
        place(line.points, object, 0.0f);
        const bool isEmpty = line.points.size() < (line.closed ? 3u : 2u) ||
                             (line.closed && std::abs(doubleArea(line.points)) <= kSlack);
        if (isEmpty) {
            refuse("it has neither area nor length");
        } else {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

TileArea areaOfTile(const tiled::Tile& tile, Vec2 cell, float raised) {
    AreaCollector area{cell, raised};
    for (const Object& object : tile.collision) area.add(object);
    return area.take();
}

}  // namespace plumb
