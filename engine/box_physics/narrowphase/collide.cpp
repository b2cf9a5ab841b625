#include "box_physics/narrowphase/collide.hpp"

#include <algorithm>

#include "math/portable.hpp"

namespace plumb::box_physics {

namespace {

constexpr float kSameDirection = 0.999f;  // cosine: touches closer than this are one

/// How far a body that is being moved may have come up under somebody's feet in one step (m).
float riseOf(const World& world, std::uint32_t body) {
    if ((world.bodies.flags[body] & kHasTarget) == 0) return 0.0f;
    return length(world.bodies.target[body] - world.bodies.position[body]);
}

/// A one-way surface holds what stands on it or comes down on it.
bool holds(const Touch& touch, const Mover& mover, float depth, const Settings& settings, Vec2 up) {
    return dot(touch.normal, up) > 0.7f && touch.separation >= -depth &&
           dot(mover.path, up) <= settings.touchDistance;
}

bool sameBefore(const Touch& a, const Touch& b) {
    return a.time != b.time ? a.time < b.time : a.separation < b.separation;
}

void collideWithField(const World& world, const Mover& mover, std::uint32_t body, Vec2 place,
                      const Settings& settings, Vec2 up, TouchList& touches) {
    const TileField& field = *world.fields[world.bodies.shape[body].field];
    Mover local = mover;
    local.centre = mover.centre - place;
    const Vec2 end = local.centre + local.path;
    const Vec2 margin = local.half + Vec2{settings.touchDistance, settings.touchDistance};
    const Vec2 low = min(local.centre, end) - margin;
    const Vec2 high = max(local.centre, end) + margin;
    const Vec2 cell = field.cellSize();
    const int minX = std::max(floorToInt(low.x / cell.x), 0);
    const int minY = std::max(floorToInt(low.y / cell.y), 0);
    const int maxX = std::min(floorToInt(high.x / cell.x), field.width() - 1);
    const int maxY = std::min(floorToInt(high.y / cell.y), field.height() - 1);
    for (int y = minY; y <= maxY; ++y) {
        for (int x = minX; x <= maxX; ++x) {
            if (!field.isSolid(x, y)) continue;
            if (field.isBox(x, y) && field.coveredSides(x, y) == 15u) continue;
            const Touch touch = sweepToConvex(local, field.outline(x, y), settings);
            if (!touch.hit ||
                (field.isOneWay(x, y) && !holds(touch, mover, settings.oneWayDepth, settings, up)))
                continue;
            touches.add(touch);
        }
    }
}

}  // namespace

void TouchList::add(const Touch& touch) {
    for (int i = 0; i < count; ++i) {
        Touch& known = items[i];
        if (known.rank != touch.rank || dot(known.normal, touch.normal) < kSameDirection) continue;
        if (sameBefore(touch, known)) known = touch;
        return;
    }
    if (count < kMost) items[count++] = touch;
}

void TouchList::finish() {
    bool faces = false;
    float soonest = 2.0f;
    for (int i = 0; i < count; ++i) {
        faces = faces || items[i].rank == TouchRank::Face;
        if (items[i].time > 0.0f) soonest = std::min(soonest, items[i].time);
    }
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        if (faces && items[i].rank == TouchRank::InnerCorner) continue;
        if (items[i].time > soonest + 0.001f) continue;
        items[kept++] = items[i];
    }
    count = kept;
}

const Touch* TouchList::first() const {
    const Touch* best = nullptr;
    for (int i = 0; i < count; ++i) {
        if (best == nullptr || sameBefore(items[i], *best)) best = &items[i];
    }
    return best;
}

void collideAt(const World& world, const Mover& mover, std::uint32_t body, Vec2 place,
               const Settings& settings, Vec2 up, TouchList& touches) {
    const Shape& shape = world.bodies.shape[body];
    if (shape.kind == ShapeKind::Tiles) {
        collideWithField(world, mover, body, place, settings, up, touches);
        touches.finish();
        return;
    }
    const Vec2 centre = place + shape.centre;
    const Touch touch = shape.kind == ShapeKind::Circle ? sweepToCircle(mover, centre, shape.half.x, settings)
                                                        : sweepToBox(mover, centre, shape.half, settings);
    if (!touch.hit) return;
    const float depth = settings.oneWayDepth + riseOf(world, body);
    if ((world.bodies.flags[body] & kOneWay) != 0 && !holds(touch, mover, depth, settings, up)) return;
    touches.add(touch);
}

Mover moverOf(const World& world, std::uint32_t body, Vec2 path) {
    const Shape& shape = world.bodies.shape[body];
    return {shape.kind, world.bodies.position[body] + shape.centre, shape.half, path, 0.0f};
}

}  // namespace plumb::box_physics
