#include "box_physics/queries/cast.hpp"

#include <algorithm>

#include "box_physics/narrowphase/collide.hpp"
#include "box_physics/queries/candidates.hpp"
#include "box_physics/simulation.hpp"

namespace plumb::box_physics {

namespace {

constexpr float kAlong = 1e-4f;
constexpr float kRayHalf = 1e-5f;  // m: a ray is a circle too small to see

bool sees(const World& world, const Filter& filter, std::uint32_t i) {
    const Bodies& b = world.bodies;
    if ((b.layers[i] & filter.mask) == 0 || (filter.layers & b.mask[i]) == 0) return false;
    if ((b.flags[i] & kTrigger) != 0 && !filter.triggers) return false;
    if ((b.flags[i] & kOneWay) != 0 && !filter.oneWay) return false;
    return BodyId{i, b.generation[i]} != filter.except;
}

bool reaches(const AABB& a, const AABB& b) {
    return a.max.x >= b.min.x && a.min.x <= b.max.x && a.max.y >= b.min.y && a.min.y <= b.max.y;
}

/// Where a query sees a body: a kinematic one where this tick takes it, since its owner moves it before
/// others.
Vec2 placeOf(const World& world, std::uint32_t i) {
    return (world.bodies.flags[i] & kHasTarget) != 0 ? world.bodies.target[i] : world.bodies.position[i];
}

/// Every body that the query sees and whose bounds reach the box.
template <class Visit>
void forEachSeen(World& world, const AABB& box, const Filter& filter, Visit visit) {
    refreshFixedGrid(world);
    forEachFixed(world, box, [&](std::uint32_t i) {
        if (sees(world, filter, i)) visit(i);
    });
    if (!filter.movers) return;
    for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
        const BodyKind kind = world.bodies.kind[i];
        if (kind == BodyKind::None || kind == BodyKind::Static || !sees(world, filter, i)) continue;
        if (reaches(box, world.bodies.shape[i].boundsAt(placeOf(world, i)))) visit(i);
    }
}

AABB boundsOf(const Mover& mover, float margin) {
    const Vec2 end = mover.centre + mover.path;
    return grown({min(mover.centre, end) - mover.half, max(mover.centre, end) + mover.half}, margin);
}

}  // namespace

std::optional<CastHit> shapeCast(World& world, const Mover& mover, const Settings& settings,
                                 const Filter& filter) {
    std::optional<CastHit> best;
    const Vec2 up = filter.oneWay ? upOf(settings) : Vec2{};
    forEachSeen(world, boundsOf(mover, settings.touchDistance), filter, [&](std::uint32_t i) {
        TouchList touches;
        collideAt(world, mover, i, placeOf(world, i), settings, up, touches);
        for (int k = 0; k < touches.count; ++k) {
            const Touch& touch = touches.items[k];
            // Along a surface, rounding decides whether the way leads into it; that much does not count.
            if (dot(touch.normal, mover.path) >= -kAlong * length(mover.path) && mover.path != Vec2{})
                continue;
            if (best && (best->touch.time < touch.time ||
                         (best->touch.time == touch.time && best->touch.separation <= touch.separation))) {
                continue;
            }
            best = CastHit{{i, world.bodies.generation[i]}, touch, touchPoint(mover, touch)};
        }
    });
    return best;
}

std::optional<CastHit> rayCast(World& world, Vec2 from, Vec2 path, const Settings& settings,
                               const Filter& filter) {
    Settings exact = settings;
    exact.touchDistance = 0.0f;
    return shapeCast(world, {ShapeKind::Circle, from, {kRayHalf, kRayHalf}, path, 0.0f}, exact, filter);
}

void overlap(World& world, Mover mover, const Settings& settings, const Filter& filter,
             std::vector<BodyId>& found) {
    found.clear();
    mover.path = {};
    Settings exact = settings;
    exact.touchDistance = exact.seamDistance = 0.0f;
    forEachSeen(world, boundsOf(mover, 0.0f), filter, [&](std::uint32_t i) {
        TouchList touches;
        collideAt(world, mover, i, placeOf(world, i), exact, upOf(settings), touches);
        const Touch* touch = touches.first();
        if (touch != nullptr && touch->separation < 0.0f) found.push_back({i, world.bodies.generation[i]});
    });
    std::sort(found.begin(), found.end(), [](BodyId a, BodyId b) { return a.index < b.index; });
}

}  // namespace plumb::box_physics
