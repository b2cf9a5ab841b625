#include "physics/queries/lists.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/contacts/contacts.hpp"
#include "physics/model/edits.hpp"

namespace plumb::physics {

namespace {

template <class Act>
void forTouching(const World& world, Act&& act) {
    forContacts(world, [&](const Contact& contact) {
        if ((contact.flags & kTouching) != 0) act(contact);
    });
}

template <class Is>
void collect(const World& world, std::vector<const Contact*>& found, bool lives, Is&& is) {
    found.clear();
    if (!lives) return;
    forTouching(world, [&](const Contact& contact) {
        if ((contact.flags & kTriggered) == 0 && is(contact)) found.push_back(&contact);
    });
}

constexpr float kFar = std::numeric_limits<float>::max();
constexpr AABB kNothing{{kFar, kFar}, {-kFar, -kFar}};

}  // namespace

void shapesOf(const World& world, BodyId body, std::vector<ShapeId>& found) {
    found.clear();
    if (!alive(world, body)) return;
    forShapesOf(world, body.index, [&](std::uint32_t s) {
        found.push_back({s, world.shapes.info[s].generation});
    });
    std::reverse(found.begin(), found.end());  // the last one is the first of the list
}

void jointsOf(const World& world, BodyId body, std::vector<JointId>& found) {
    found.clear();
    if (!alive(world, body)) return;
    forJointsOf(world, body.index, [&](std::uint32_t j) {
        found.push_back({j, world.joints.hot[j].generation});
    });
    std::reverse(found.begin(), found.end());
}

void contactsOf(const World& world, BodyId body, std::vector<const Contact*>& found) {
    collect(world, found, alive(world, body),
            [&](const Contact& c) { return c.bodyA == body.index || c.bodyB == body.index; });
}

void contactsOf(const World& world, ShapeId shape, std::vector<const Contact*>& found) {
    collect(world, found, alive(world, shape),
            [&](const Contact& c) { return c.shapeA == shape.index || c.shapeB == shape.index; });
}

void overlapsOf(const World& world, ShapeId trigger, std::vector<ShapeId>& found) {
    found.clear();
    if (!alive(world, trigger)) return;
    forTouching(world, [&](const Contact& contact) {
        const bool isA = contact.shapeA == trigger.index;
        if ((contact.flags & kTriggered) == 0 || (!isA && contact.shapeB != trigger.index)) return;
        const std::uint32_t other = isA ? contact.shapeB : contact.shapeA;
        found.push_back({other, world.shapes.info[other].generation});
    });
}

void movedBodies(const World& world, std::vector<BodyId>& found) {
    found.clear();
    const auto add = [&](BodyId body) {
        if ((world.bodies.info[body.index].flags & kMoved) != 0) found.push_back(body);
    };
    for (const std::uint32_t body : world.awake) add({body, world.bodies.info[body].generation});
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
    AABB bounds = kNothing;
    forShapesOf(world, body.index, [&](std::uint32_t s) {
        bounds = {min(bounds.min, world.shapes.bounds[s].min), max(bounds.max, world.shapes.bounds[s].max)};
    });
    return bounds.min.x <= bounds.max.x ? bounds : AABB{};
}

AABB boundsOf(const World& world) {
    AABB bounds = kNothing;
    for (std::size_t s = 0; s < world.shapes.size(); ++s) {
        if (world.shapes.motion[s] == ProxyMotion::Gone) continue;
        bounds = {min(bounds.min, world.shapes.bounds[s].min), max(bounds.max, world.shapes.bounds[s].max)};
    }
    return bounds.min.x <= bounds.max.x ? bounds : AABB{};
}

}  // namespace plumb::physics
