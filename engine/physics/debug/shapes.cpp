#include <algorithm>

#include "physics/debug/picture.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

DebugRole roleOf(ProxyMotion motion) {
    switch (motion) {
        case ProxyMotion::Kinematic: return DebugRole::Driven;
        case ProxyMotion::Awake: return DebugRole::Awake;
        case ProxyMotion::Asleep: return DebugRole::Asleep;
        case ProxyMotion::Static:
        case ProxyMotion::Gone: break;
    }
    return DebugRole::Fixed;
}

void drawSoftBodies(const Picture& picture) {
    const std::vector<SoftBody>& all = picture.world.softBodies.all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const SoftBody& soft = all[i];
        if (!soft.isAlive || !picture.isAmong(picture.choice.softBodies, i)) continue;
        for (const SoftLink& link : soft.links) {
            picture.canvas.line(picture.seen(soft.particles[link.a].place),
                                picture.seen(soft.particles[link.b].place), DebugRole::Soft);
        }
    }
}

/// Identifies the island of a body: the root of its tree, or the first body of its sleeping island.
std::uint32_t headOfIsland(const World& world, std::uint32_t body) {
    const std::uint32_t asleep = world.sleepers.islandOf[body];
    if (asleep != kNone) return world.sleepers.islands[asleep].firstBody;
    while (world.bodies.info[body].island != body) body = world.bodies.info[body].island;
    return body;
}

Vec2 middleOf(const Picture& picture, std::uint32_t shape, std::uint32_t body) {
    return apply(picture.frame(body), picture.outline(shape).centre);
}

/// The outlines of all shapes that are triggers, or that are not; of small ones the bounds.
void drawOutlines(const Picture& picture, bool triggers) {
    const Shapes& shapes = picture.world.shapes;
    picture.forShapes([&](std::uint32_t s, std::uint32_t body) {
        const std::uint8_t flags = shapes.info[s].flags;
        if (((flags & kTrigger) != 0) != triggers) return;
        const DebugRole role = triggers ? DebugRole::Trigger : roleOf(shapes.motion[s]);
        if (const AABB box = picture.box(s); picture.isDot(box)) return picture.canvas.box(box, role);
        const Frame frame = picture.frame(body);
        drawOutline(picture.canvas, picture.outline(s), frame, role);
        if (triggers || (flags & kOneWay) == 0) return;
        const Vec2 from = middleOf(picture, s, body);
        picture.canvas.arrow(
            from, from + kOneWayArrow * rotate(frame.rotation, shapes.extrasOf(s).oneWayDirection), role);
    });
}

}  // namespace

void drawShapes(const Picture& picture) {
    drawOutlines(picture, false);
    drawSoftBodies(picture);
}

void drawTriggers(const Picture& picture) {
    drawOutlines(picture, true);
    picture.forContacts(true, [&](const Contact& contact) {
        picture.canvas.line(middleOf(picture, contact.shapeA, contact.bodyA),
                            middleOf(picture, contact.shapeB, contact.bodyB), DebugRole::Visitor);
    });
}

void drawBounds(const Picture& picture) {
    const Shapes& shapes = picture.world.shapes;
    picture.forShapes([&](std::uint32_t s, std::uint32_t body) {
        picture.canvas.box(boundsOf(shapes.geometry[s], shapes.corners, picture.frame(body)),
                           DebugRole::Bounds);
    });
}

void drawBroadPhase(const Picture& picture) {
    const Workspace* work = picture.choice.lastStep;
    if (work != nullptr && work->broadPhase != nullptr && !picture.choice.chosenOnly) {
        work->broadPhase->visitRegions([&picture](const AABB& region) {
            picture.canvas.box({picture.seen(region.min), picture.seen(region.max)}, DebugRole::Region);
        });
    }
    picture.forShapes(
        [&](std::uint32_t s, std::uint32_t) { picture.canvas.box(picture.box(s), DebugRole::BroadPhase); });
}

void drawIslands(const Picture& picture) {
    picture.forShapes([&](std::uint32_t s, std::uint32_t body) {
        if (!isDynamic(picture.world, body)) return;
        drawOutline(picture.canvas, picture.outline(s), picture.frame(body),
                    {DebugRole::Island, headOfIsland(picture.world, body)});
    });
}

void drawRest(const Picture& picture) {
    const Settings& settings = picture.world.settings;
    picture.forShapes([&](std::uint32_t s, std::uint32_t body) {
        if (!isDynamic(picture.world, body)) return;
        const bool asleep = picture.world.shapes.motion[s] == ProxyMotion::Asleep;
        const float restTime = picture.world.bodies.motion[body].restTime;
        const float part = asleep ? 1.0f : std::min(restTime / std::max(settings.sleepTime, 1e-6f), 1.0f);
        if (part == 0.0f) return;
        const ScaledConvex scaled{picture.outline(s), picture.pose(body).localCentre, part};
        drawOutline(picture.canvas, scaled.outline(), picture.frame(body), DebugRole::Rest);
    });
}

}  // namespace plumb::physics
