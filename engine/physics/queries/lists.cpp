#include "physics/queries/lists.hpp"

#include <algorithm>

#include "physics/broadphase/overlap.hpp"
#include "physics/contacts/contacts.hpp"
#include "physics/queries/candidates.hpp"

namespace plumb::physics {

namespace {

/// Replaces kNowhere (no bounds were merged) by a box at the origin.
AABB finished(const AABB& bounds) { return bounds == kNowhere ? AABB{} : bounds; }

}  // namespace

void shapesOf(const World& world, BodyId body, std::vector<ShapeId>& found) {
    found.clear();
    if (!alive(world, body)) return;
    forShapesOf(world, body.index, [&](std::uint32_t s) { found.push_back(idOfShape(world, s)); });
    std::reverse(found.begin(), found.end());  // a body lists its shapes in reverse order
}

void jointsOf(const World& world, BodyId body, std::vector<JointId>& found) {
    found.clear();
    if (!alive(world, body)) return;
    forJointsOf(world, body.index, [&](std::uint32_t j) { found.push_back(idOfJoint(world, j)); });
    std::reverse(found.begin(), found.end());
}

void contactsOf(const World& world, BodyId body, std::vector<const Contact*>& found) {
    found.clear();
    if (!alive(world, body)) return;
    forTouching(world, false, [&](const Contact& contact) {
        if (contact.bodyA == body.index || contact.bodyB == body.index) found.push_back(&contact);
    });
}

void contactsOf(const World& world, ShapeId shape, std::vector<const Contact*>& found) {
    found.clear();
    if (!alive(world, shape)) return;
    forTouching(world, false, [&](const Contact& contact) {
        if (contact.shapeA == shape.index || contact.shapeB == shape.index) found.push_back(&contact);
    });
}

void overlapsOf(const World& world, ShapeId trigger, std::vector<ShapeId>& found) {
    found.clear();
    if (!alive(world, trigger)) return;
    forTouching(world, true, [&](const Contact& contact) {
        const bool isA = contact.shapeA == trigger.index;
        if (isA || contact.shapeB == trigger.index)
            found.push_back(idOfShape(world, isA ? contact.shapeB : contact.shapeA));
    });
}

void movedBodies(const World& world, std::vector<BodyId>& found) {
    found.clear();
    const auto add = [&](BodyId body) {
        if ((world.bodies.info[body.index].flags & kMoved) != 0) found.push_back(body);
    };
    for (const std::uint32_t body : world.awake) add(idOfBody(world, body));
    for (const BodyId body : world.fellAsleep) add(body);
}

FixedList<ContactPoint, 2> contactPoints(const World& world, const Contact& contact) {
    FixedList<ContactPoint, 2> points;
    const BodyPose& a = world.bodies.pose[contact.bodyA];
    for (int i = 0; i < contact.count; ++i) {
        const float separation = i == 0 ? contact.separation0 : contact.separation1;
        const Vec2 arm = rotate(a.rotation, pointOf(world, contact, i));
        points.push({a.centre + (arm + (0.5f * separation) * contact.normal), separation,
                     std::fabs(i == 0 ? contact.impulse0 : contact.impulse1)});
    }
    return points;
}

AABB boundsOf(const World& world, BodyId body) {
    if (!alive(world, body)) return {};
    AABB bounds = kNowhere;
    forShapesOf(world, body.index, [&](std::uint32_t s) { bounds = merged(bounds, world.shapes.bounds[s]); });
    return finished(bounds);
}

AABB boundsOf(const World& world) {
    AABB bounds = kNowhere;
    for (std::size_t s = 0; s < world.shapes.size(); ++s) {
        if (world.shapes.motion[s] != ProxyMotion::Gone) bounds = merged(bounds, world.shapes.bounds[s]);
    }
    return finished(bounds);
}

}  // namespace plumb::physics
