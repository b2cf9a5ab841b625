#include "box_physics/tile_field.hpp"

#include <algorithm>
#include <initializer_list>

#include "core/assert.hpp"

namespace plumb::box_physics {

namespace {

constexpr Vec2 kOutward[4] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};  // top, right, bottom, left

/// How far along a side a point lies, and whether it lies on it at all.
bool onSide(int side, Vec2 point, float& along) {
    const bool level = side == 0 || side == 2;
    along = level ? point.x : point.y;
    const float across = level ? point.y : point.x;
    return across == ((side == 1 || side == 2) ? 1.0f : 0.0f);
}

}  // namespace

TileField::TileField(int width, int height, Vec2 cellSize)
    : width_{std::max(width, 0)}, height_{std::max(height, 0)}, cellSize_{cellSize} {
    cells_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    covered_.resize(cells_.size());
    const auto add = [this](std::initializer_list<Vec2> points, bool oneWay = false) {
        addShape(points.begin(), static_cast<int>(points.size()), oneWay);
    };
    // In the order of TileShape.
    shapes_.emplace_back();
    add({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    add({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
    add({{0, 1}, {1, 0}, {1, 1}});
    add({{0, 0}, {1, 1}, {0, 1}});
    add({{0, 1}, {1, 0.5f}, {1, 1}});
    add({{0, 0.5f}, {1, 0}, {1, 1}, {0, 1}});
    add({{0, 0}, {1, 0.5f}, {1, 1}, {0, 1}});
    add({{0, 0.5f}, {1, 1}, {0, 1}});
    add({{0, 0}, {1, 0}, {1, 0.5f}, {0, 0.5f}});
    add({{0, 0.5f}, {1, 0.5f}, {1, 1}, {0, 1}});
}

Result<TileShape> TileField::addPolygon(const Vec2* points, int count, bool oneWay) {
    if (!isConvex(points, count)) {
        return Error{"TileField::addPolygon", "the points do not form a convex polygon of 3 to 8 corners",
                     "list the corners in order, without bends inwards"};
    }
    if (shapes_.size() >= kMaxShapes) {
        return Error{"TileField::addPolygon", "too many different tile shapes", "use at most 4096"};
    }
    addShape(points, count, oneWay);
    return static_cast<TileShape>(shapes_.size() - 1);
}

void TileField::addShape(const Vec2* points, int count, bool oneWay) {
    CellShape shape;
    shape.convex = convexFrom(points, count);
    shape.oneWay = oneWay;
    for (int side = 0; side < 4; ++side) {
        for (int face = 0; face < count; ++face) {
            float from = 0.0f;
            float to = 0.0f;
            const Vec2 a = shape.convex.points[static_cast<std::size_t>(face)];
            const Vec2 b = shape.convex.points[static_cast<std::size_t>(shape.convex.next(face))];
            if (!onSide(side, a, from) || !onSide(side, b, to)) continue;
            shape.sides[side] = {std::min(from, to), std::max(from, to)};
            shape.faceOfSide[side] = face;
        }
    }
    shapes_.push_back(shape);
}

void TileField::set(int x, int y, TileShape shape) {
    PLUMB_ASSERT(static_cast<std::size_t>(shape) < shapes_.size(), "set a tile shape that this field has");
    if (has(x, y)) cells_[slot(x, y)] = static_cast<std::uint16_t>(shape);
}

bool TileField::covers(int x, int y, int side, Span span) const {
    if (!isSolid(x, y)) return false;
    const CellShape& shape = shapes_[cells_[slot(x, y)]];
    return !shape.oneWay && shape.sides[side].from <= span.from && shape.sides[side].to >= span.to;
}

void TileField::finish() {
    Hasher hasher;
    hasher.add(static_cast<std::uint64_t>(width_) << 32 | static_cast<std::uint32_t>(height_));
    hasher.add(cellSize_.x);
    hasher.add(cellSize_.y);
    hasher.addBytes(cells_.data(), cells_.size() * sizeof(cells_[0]));
    for (std::size_t i = static_cast<std::size_t>(TileShape::Count); i < shapes_.size(); ++i) {
        for (int k = 0; k < shapes_[i].convex.count; ++k) {
            hasher.add(shapes_[i].convex.points[static_cast<std::size_t>(k)].x);
            hasher.add(shapes_[i].convex.points[static_cast<std::size_t>(k)].y);
        }
        hasher.add(std::uint64_t{shapes_[i].oneWay});
    }
    contentHash_ = hasher.value();
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            const std::uint16_t cell = cells_[slot(x, y)];
            unsigned bits = 0;
            for (int side = 0; side < 4 && cell != 0; ++side) {
                const Span span = shapes_[cell].sides[side];
                const int nx = x + static_cast<int>(kOutward[side].x);
                const int ny = y + static_cast<int>(kOutward[side].y);
                const bool hasFace = span.from < span.to;
                if (hasFace && covers(nx, ny, (side + 2) % 4, span)) bits |= 1u << side;
            }
            covered_[slot(x, y)] = static_cast<std::uint8_t>(bits);
        }
    }
}

Convex TileField::outline(int x, int y) const {
    const CellShape& shape = shapes_[cells_[slot(x, y)]];
    Convex convex = shape.convex;
    const Vec2 corner{static_cast<float>(x) * cellSize_.x, static_cast<float>(y) * cellSize_.y};
    for (int i = 0; i < convex.count; ++i) {
        Vec2& point = convex.points[static_cast<std::size_t>(i)];
        point = corner + scaled(point, cellSize_);
    }
    if (cellSize_.x != cellSize_.y) {
        const unsigned kept = convex.inner;
        convex = convexFrom(convex.points.data(), convex.count);
        convex.inner = kept;
    }
    for (int side = 0; side < 4; ++side) {
        if ((covered_[slot(x, y)] >> side & 1u) != 0) convex.inner |= 1u << shape.faceOfSide[side];
    }
    return convex;
}

}  // namespace plumb::box_physics
