#include "physics/debug_draw.hpp"

#include <array>
#include <string>

#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

constexpr float kPointRadius = 0.02f;    // m
constexpr float kNormalLength = 0.2f;    // m
constexpr float kImpulseLength = 0.1f;   // m for 1 N s
constexpr float kVelocityLength = 0.1f;  // s: metres drawn for 1 m/s

/// A world, and what to draw it on.
struct Picture {
    const World& world;
    DebugCanvas& canvas;
    Place origin;

    [[nodiscard]] const BodyPose& pose(std::uint32_t body) const { return world.bodies.pose[body]; }
    [[nodiscard]] Vec2 centre(std::uint32_t body) const { return pose(body).centre - origin; }
    /// From a body's centre of mass, in its frame.
    [[nodiscard]] Vec2 place(std::uint32_t body, Vec2 arm) const {
        return centre(body) + rotate(pose(body).rotation, arm);
    }
    [[nodiscard]] Frame frame(std::uint32_t body) const {
        return {place(body, -pose(body).localCentre), pose(body).rotation};
    }
    [[nodiscard]] bool exists(std::uint32_t body) const {
        return world.bodies.info[body].kind != BodyKind::None;
    }
    [[nodiscard]] bool isDynamic(std::uint32_t body) const {
        return world.bodies.info[body].kind == BodyKind::Dynamic;
    }
};

DebugRole roleOf(const World& world, std::uint32_t shape) {
    if ((world.shapes.info[shape].flags & kTrigger) != 0) return DebugRole::Trigger;
    switch (world.shapes.motion[shape]) {
        case ProxyMotion::Kinematic: return DebugRole::Driven;
        case ProxyMotion::Awake: return DebugRole::Awake;
        case ProxyMotion::Asleep: return DebugRole::Asleep;
        case ProxyMotion::Static:
        case ProxyMotion::Gone: break;
    }
    return DebugRole::Fixed;
}

/// Faces moved out by the radius, and a circle at each corner.
void drawRound(DebugCanvas& canvas, std::span<const Corner> corners, const Frame& frame, float radius,
               DebugRole role) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner corner = apply(frame, corners[i]);
        const Vec2 next = apply(frame, corners[i + 1 < corners.size() ? i + 1 : 0].point);
        canvas.circle(corner.point, radius, role);
        if (corners.size() > 1)
            canvas.line(corner.point + radius * corner.normal, next + radius * corner.normal, role);
    }
}

void drawOutline(DebugCanvas& canvas, const Convex& convex, const Frame& frame, DebugRole role) {
    const std::span<const Corner> corners = convex.corners();
    if (convex.radius > 0.0f) return drawRound(canvas, corners, frame, convex.radius, role);
    if (corners.size() == 2)
        return canvas.line(apply(frame, corners[0].point), apply(frame, corners[1].point), role);
    std::array<Vec2, kMaxCorners> points;
    for (std::size_t i = 0; i < corners.size(); ++i) points[i] = apply(frame, corners[i].point);
    canvas.polygon({points.data(), corners.size()}, role);
}

void drawBox(DebugCanvas& canvas, Vec2 low, Vec2 high, DebugRole role) {
    const std::array<Vec2, 4> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
    canvas.polygon(corners, role);
}

template <class Draw>
void forShapes(const Picture& picture, Draw&& draw) {
    const Shapes& shapes = picture.world.shapes;
    for (std::uint32_t s = 0; s < shapes.size(); ++s) {
        if (shapes.motion[s] != ProxyMotion::Gone) draw(s, picture.frame(shapes.info[s].body));
    }
}

void drawShapes(const Picture& picture) {
    const Shapes& shapes = picture.world.shapes;
    forShapes(picture, [&](std::uint32_t s, const Frame& frame) {
        drawOutline(picture.canvas, convexOf(shapes.geometry[s], shapes.corners), frame,
                    roleOf(picture.world, s));
    });
}

void drawBounds(const Picture& picture) {
    const Shapes& shapes = picture.world.shapes;
    forShapes(picture, [&](std::uint32_t s, const Frame& frame) {
        const AABB box = boundsOf(shapes.geometry[s], shapes.corners, frame);
        drawBox(picture.canvas, box.min, box.max, DebugRole::Bounds);
    });
}

void drawBroadPhase(const Picture& picture) {
    forShapes(picture, [&](std::uint32_t s, const Frame&) {
        const AABB& box = picture.world.shapes.bounds[s];
        drawBox(picture.canvas, Place{box.min} - picture.origin, Place{box.max} - picture.origin,
                DebugRole::BroadPhase);
    });
}

/// What a contact knows of one of its points.
struct ContactPoint {
    Vec2 place;
    Vec2 normal;
    float impulse;
};

/// All contacts that touch, awake ones first.
template <class Draw>
void forContactPoints(const Picture& picture, Draw&& draw) {
    const auto drawOne = [&](const Contact& contact) {
        if ((contact.flags & kTouching) == 0) return;
        for (int i = 0; i < contact.count; ++i) {
            draw(ContactPoint{picture.place(contact.bodyA, contact.anchors[i].a), contact.normal,
                              i == 0 ? contact.impulse0 : contact.impulse1});
        }
    };
    const Sleepers& sleepers = picture.world.sleepers;
    for (const Contact& contact : picture.world.contacts) drawOne(contact);
    for (const SleepingIsland& island : sleepers.islands) {
        for (std::uint32_t c = island.firstContact; c != kNone; c = sleepers.nextContact[c]) {
            drawOne(sleepers.contacts[c]);
        }
    }
}

void drawContacts(const Picture& picture) {
    forContactPoints(picture, [&](const ContactPoint& point) {
        picture.canvas.circle(point.place, kPointRadius, DebugRole::Contact);
    });
}

void drawNormals(const Picture& picture) {
    forContactPoints(picture, [&](const ContactPoint& point) {
        picture.canvas.arrow(point.place, point.place + kNormalLength * point.normal, DebugRole::Normal);
    });
}

void drawImpulses(const Picture& picture) {
    forContactPoints(picture, [&](const ContactPoint& point) {
        if (point.impulse == 0.0f) return;
        const Vec2 way = (kImpulseLength * point.impulse) * point.normal;
        picture.canvas.arrow(point.place, point.place + way, DebugRole::Impulse);
    });
}

void drawJoints(const Picture& picture) {
    for (const Joint& joint : picture.world.joints.hot) {
        if (joint.bodyA == kNone) continue;
        const Vec2 a = picture.place(joint.bodyA, joint.anchorA),
                   b = picture.place(joint.bodyB, joint.anchorB);
        picture.canvas.line(picture.centre(joint.bodyA), a, DebugRole::Joint);
        picture.canvas.line(picture.centre(joint.bodyB), b, DebugRole::Joint);
        picture.canvas.line(a, b, DebugRole::Joint);
        picture.canvas.circle(b, kPointRadius, DebugRole::Joint);
    }
}

template <class Draw>
void forBodies(const Picture& picture, Draw&& draw) {
    for (std::uint32_t body = 0; body < picture.world.bodies.size(); ++body) {
        if (picture.exists(body)) draw(body);
    }
}

void drawVelocities(const Picture& picture) {
    forBodies(picture, [&](std::uint32_t body) {
        const Vec2 velocity = picture.world.bodies.motion[body].velocity;
        if (velocity == Vec2{}) return;
        const Vec2 from = picture.centre(body);
        picture.canvas.arrow(from, from + kVelocityLength * velocity, DebugRole::Velocity);
    });
}

void drawCentres(const Picture& picture) {
    forBodies(picture, [&](std::uint32_t body) {
        if (picture.isDynamic(body))
            picture.canvas.circle(picture.centre(body), kPointRadius, DebugRole::Centre);
    });
}

/// Who stands for the island of a body: the root of its tree, or the first of those that rest together.
std::uint32_t headOfIsland(const World& world, std::uint32_t body) {
    const std::uint32_t asleep = world.sleepers.islandOf[body];
    if (asleep != kNone) return world.sleepers.islands[asleep].firstBody;
    while (world.bodies.info[body].island != body) body = world.bodies.info[body].island;
    return body;
}

void drawIslands(const Picture& picture) {
    forBodies(picture, [&](std::uint32_t body) {
        if (!picture.isDynamic(body)) return;
        const std::uint32_t head = headOfIsland(picture.world, body);
        if (head == body) {
            picture.canvas.text(picture.centre(body), std::to_string(body), DebugRole::Island);
        } else {
            picture.canvas.line(picture.centre(body), picture.centre(head), DebugRole::Island);
        }
    });
}

struct Part {
    unsigned bit;
    void (*draw)(const Picture& picture);
};

constexpr Part kParts[] = {
    {kDrawBroadPhase, drawBroadPhase}, {kDrawBounds, drawBounds},     {kDrawShapes, drawShapes},
    {kDrawIslands, drawIslands},       {kDrawJoints, drawJoints},     {kDrawCentres, drawCentres},
    {kDrawVelocities, drawVelocities}, {kDrawContacts, drawContacts}, {kDrawNormals, drawNormals},
    {kDrawImpulses, drawImpulses},
};

}  // namespace

void debugDraw(const World& world, DebugCanvas& canvas, unsigned parts, Place origin) {
    const Picture picture{world, canvas, origin};
    for (const Part& part : kParts) {
        if ((parts & part.bit) != 0) part.draw(picture);
    }
}

}  // namespace plumb::physics
