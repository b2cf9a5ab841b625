#include <algorithm>

#include "physics/debug/picture.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

bool isTrigger(const World& world, std::uint32_t shape) {
    return (world.shapes.info[shape].flags & kTrigger) != 0;
}

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

}  // namespace

void drawShapes(const Picture& picture) {
    const Shapes& shapes = picture.world.shapes;
    const auto stops = [&](std::uint32_t s) { return !isTrigger(picture.world, s); };
    picture.forShapesThat(stops, [&](std::uint32_t s, std::uint32_t body, const AABB& box) {
        const DebugRole role = roleOf(shapes.motion[s]);
        if (picture.isDot(box)) return picture.canvas.box(box, role);
        const Frame frame = picture.frame(body);
        const Convex outline = picture.outline(s);
        drawOutline(picture.canvas, outline, frame, role);
        if ((shapes.info[s].flags & kOneWay) == 0) return;
        const Vec2 from = apply(frame, outline.centre);
        picture.canvas.arrow(
            from, from + kOneWayArrow * rotate(frame.rotation, shapes.extrasOf(s).oneWayDirection), role);
    });
    drawSoftBodies(picture);
}

void drawTriggers(const Picture& picture) {
    const auto triggers = [&](std::uint32_t s) { return isTrigger(picture.world, s); };
    picture.forShapesThat(triggers, [&](std::uint32_t s, std::uint32_t body, const AABB& box) {
        if (picture.isDot(box)) return picture.canvas.box(box, DebugRole::Trigger);
        drawOutline(picture.canvas, picture.outline(s), picture.frame(body), DebugRole::Trigger);
    });
    const auto middle = [&](std::uint32_t shape, std::uint32_t body) {
        return apply(picture.frame(body), picture.outline(shape).centre);
    };
    picture.forContacts(true, [&](const Contact& contact) {
        picture.canvas.line(middle(contact.shapeA, contact.bodyA), middle(contact.shapeB, contact.bodyB),
                            DebugRole::Visitor);
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
        if (!picture.isDynamic(body)) return;
        drawOutline(picture.canvas, picture.outline(s), picture.frame(body),
                    {DebugRole::Island, headOfIsland(picture.world, body)});
    });
}

void drawRest(const Picture& picture) {
    const Settings& settings = picture.world.settings;
    picture.forShapes([&](std::uint32_t s, std::uint32_t body) {
        if (!picture.isDynamic(body)) return;
        const bool asleep = picture.world.shapes.motion[s] == ProxyMotion::Asleep;
        const float restTime = picture.world.bodies.motion[body].restTime;
        const float part = asleep ? 1.0f : std::min(restTime / std::max(settings.sleepTime, 1e-6f), 1.0f);
        if (part == 0.0f) return;
        const ScaledConvex scaled{picture.outline(s), picture.pose(body).localCentre, part};
        drawOutline(picture.canvas, scaled.outline(), picture.frame(body), DebugRole::Rest);
    });
}

}  // namespace plumb::physics
