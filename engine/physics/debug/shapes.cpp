#include <algorithm>

#include "physics/debug/picture.hpp"
#include "physics/model/bodies.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

constexpr int kArcHalvings = 3;
constexpr int kArcPoints = 1 << kArcHalvings;

/// Computes directions between two outward normals, in the order of the corners.
void fillArc(Vec2* directions, Vec2 from, Vec2 to, int halvings) {
    if (halvings == 0) {
        *directions = from;
        return;
    }
    // At the ends of a capsule the normals are opposite, and their sum is zero.
    const Vec2 side{to.y - from.y, from.x - to.x};
    const Vec2 middle = normalized(dot(from, to) < 0.0f ? side : from + to);
    fillArc(directions, from, middle, halvings - 1);
    fillArc(directions + (1 << (halvings - 1)), middle, to, halvings - 1);
}

/// Draws a rounded outline: its faces, offset by the radius, with arcs between them.
void drawRounded(DebugCanvas& canvas, std::span<const Corner> corners, const Frame& frame, float radius,
                 DebugInk ink) {
    std::array<Vec2, kMaxCorners*(kArcPoints + 1)> points;
    std::size_t count = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 before = corners[i > 0 ? i - 1 : corners.size() - 1].normal;
        std::array<Vec2, kArcPoints + 1> arc;
        fillArc(arc.data(), before, corners[i].normal, kArcHalvings);
        arc.back() = corners[i].normal;
        for (const Vec2 out : arc) points[count++] = apply(frame, corners[i].point + radius * out);
    }
    canvas.polygon({points.data(), count}, ink);
}

DebugRole roleOf(ProxyMotion motion) {
    constexpr DebugRole kRoles[] = {DebugRole::Fixed, DebugRole::Fixed, DebugRole::Asleep, DebugRole::Driven,
                                    DebugRole::Awake};
    return kRoles[static_cast<std::size_t>(motion)];
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

/// Returns a body that identifies the island: the root of its tree, or the first body of a sleeping island.
std::uint32_t headOfIsland(const World& world, std::uint32_t body) {
    const std::uint32_t asleep = world.sleepers.islandOf[body];
    if (asleep != kNone) return world.sleepers.islands[asleep].firstBody;
    while (world.bodies.info[body].island != body) body = world.bodies.info[body].island;
    return body;
}

Vec2 middleOf(const Picture& picture, std::uint32_t shape, std::uint32_t body) {
    return apply(picture.frame(body), picture.outline(shape).centre);
}

/// Draws the outlines of all triggers, or of all other shapes; for small shapes only the bounds.
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

constexpr float kVelocityLength = 0.1f;  // s: meters drawn for 1 m/s
constexpr float kPathTime = 1.0f;        // s
constexpr int kPathLines = 20;

}  // namespace

void drawOutline(DebugCanvas& canvas, const Convex& convex, const Frame& frame, DebugInk ink) {
    const std::span<const Corner> corners = convex.corners();
    const Vec2 first = apply(frame, corners[0].point);
    if (corners.size() == 1) {  // a disc, with a spoke that shows its rotation
        canvas.circle(first, convex.radius, ink);
        return canvas.line(first, first + rotate(frame.rotation, {convex.radius, 0.0f}), ink);
    }
    if (convex.radius > 0.0f) return drawRounded(canvas, corners, frame, convex.radius, ink);
    if (corners.size() == 2) return canvas.line(first, apply(frame, corners[1].point), ink);
    std::array<Vec2, kMaxCorners> points;
    for (std::size_t i = 0; i < corners.size(); ++i) points[i] = apply(frame, corners[i].point);
    canvas.polygon({points.data(), corners.size()}, ink);
}

void DebugCanvas::box(const AABB& box, DebugInk ink) {
    const Vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    polygon(corners, ink);
}

void drawArc(DebugCanvas& canvas, Vec2 centre, float radius, Rot from, float angle, DebugInk ink) {
    constexpr int kLines = 2 * kArcPoints;
    const Rot rotation = rotFromAngle(angle / static_cast<float>(kLines));
    for (int i = 0; i < kLines; ++i) {
        const Rot to = normalized(rotation * from);
        canvas.line(centre + radius * Vec2{from.cos, from.sin}, centre + radius * Vec2{to.cos, to.sin}, ink);
        from = to;
    }
}

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
    if (work != nullptr && work->broadPhase != nullptr && !picture.choice.selectedOnly) {
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

void drawVelocities(const Picture& picture) {
    picture.forBodies([&](std::uint32_t body) {
        const Vec2 velocity = picture.world.bodies.motion[body].velocity;
        if (velocity == Vec2{}) return;
        const Vec2 from = picture.centre(body);
        picture.canvas.arrow(from, from + kVelocityLength * velocity, DebugRole::Velocity);
    });
}

// Like predictTransform(), but relative to the origin of the canvas, so exact far from the world's origin.
void drawPaths(const Picture& picture) {
    const World& world = picture.world;
    picture.forBodies([&](std::uint32_t body) {
        const Vec2 velocity = world.bodies.motion[body].velocity;
        if (!isDynamic(world, body) || length(velocity) < world.bodies.info[body].sleepSpeed) return;
        const Vec2 start = picture.centre(body);
        Vec2 from = start;
        for (int i = 1; i <= kPathLines; ++i) {
            const float time = kPathTime * static_cast<float>(i) / static_cast<float>(kPathLines);
            const Vec2 to = start + freeMotionOf(world, body, time).displacement;
            picture.canvas.line(from, to, DebugRole::Path);
            from = to;
        }
    });
}

void drawCentres(const Picture& picture) {
    picture.forBodies([&](std::uint32_t body) {
        if (isDynamic(picture.world, body))
            picture.canvas.circle(picture.centre(body), kPointRadius, DebugRole::Centre);
    });
}

void drawSweeps(const Picture& picture) {
    const Workspace* work = picture.choice.lastStep;
    if (work == nullptr || picture.world.awake.empty()) return;
    for (const SweptBody& swept : work->swept) {
        const std::uint32_t body = swept.body;
        if (!isDynamic(picture.world, body) || !picture.shows(body)) continue;
        const BodyPose from = swept.sweep.at(swept.sweep.begin);
        forShapesOf(picture.world, body, [&](std::uint32_t s) {
            drawOutline(picture.canvas, picture.outline(s), picture.frame(from), DebugRole::Sweep);
        });
        const Vec2 start = picture.seen(from.centre);
        picture.canvas.line(start, picture.seen(swept.sweep.at(1.0f).centre), DebugRole::Sweep);
        if (swept.hits > 0) picture.canvas.circle(start, kPointRadius, DebugRole::Impact);
    }
}

}  // namespace plumb::physics
