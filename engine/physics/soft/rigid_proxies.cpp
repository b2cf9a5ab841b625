#include "physics/soft/rigid_proxies.hpp"

#include <algorithm>
#include <limits>

#include "physics/broadphase/broadphase_update.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

bool isPushed(const World& world, std::uint32_t body) {
    return world.bodies.info[body].kind == BodyKind::Dynamic;
}

AABB boundsOf(const SoftBody& body, float dt) {
    constexpr float kFar = std::numeric_limits<float>::max();
    AABB bounds{{kFar, kFar}, {-kFar, -kFar}};
    for (const SoftParticle& p : body.particles) {
        const Vec2 here = toVec2(p.place), there = toVec2(p.place + dt * p.velocity);
        bounds = {min(bounds.min, min(here, there)), max(bounds.max, max(here, there))};
    }
    return grown(bounds, 2.0f * body.radius);
}

void findShapes(StepContext& step, const SoftBody& body) {
    const Shapes& shapes = step.world.shapes;
    std::vector<std::uint32_t>& found = step.work.softSurroundings.shapes;
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    if (step.work.broadPhase != nullptr) {
        step.work.broadPhase->query(proxiesOf(step.world), boundsOf(body, step.dt), body.mask, found);
    }
    const auto end = std::remove_if(found.begin() + first, found.end(), [&](std::uint32_t shape) {
        return (shapes.info[shape].flags & kTrigger) != 0 || (shapes.filter[shape].mask & body.layers) == 0;
    });
    found.erase(end, found.end());
    std::sort(found.begin() + first, found.end());
}

void findNeighbours(const World& world, SoftSurroundings& around) {
    around.neighbours.clear();
    for (std::uint32_t soft = 0; soft < around.ends.size(); ++soft) {
        for (const std::uint32_t shape : around.shapesOf(soft)) {
            const std::uint32_t body = world.shapes.info[shape].body;
            if (isPushed(world, body)) around.neighbours.push_back({body, soft});
        }
    }
    std::sort(around.neighbours.begin(), around.neighbours.end(),
              [](const SoftNeighbour& a, const SoftNeighbour& b) {
                  return a.body != b.body ? a.body < b.body : a.soft < b.soft;
              });
}

/// Contacts that push and have a body near a soft body.
void findContacts(const World& world, SoftSurroundings& around) {
    around.contacts.clear();
    if (around.neighbours.empty()) return;
    around.isNear.resize(world.bodies.size());
    for (const SoftNeighbour& near : around.neighbours) around.isNear[near.body] = 1;
    for (std::uint32_t i = 0; i < world.contacts.size(); ++i) {
        const Contact& contact = world.contacts[i];
        if (around.isNear[contact.bodyA] == 0 && around.isNear[contact.bodyB] == 0) continue;
        constexpr std::uint16_t kWithoutPush = kTriggered | kDisabled | kPassing;
        if ((contact.flags & kTouching) != 0 && (contact.flags & kWithoutPush) == 0)
            around.contacts.push_back(i);
    }
    for (const SoftNeighbour& near : around.neighbours) around.isNear[near.body] = 0;
}

bool isBefore(const SoftObstacle& obstacle, std::uint32_t body) { return obstacle.body < body; }

Rot turnedBy(Rot rotation, float angle) {
    return normalized(Rot{rotation.cos - angle * rotation.sin, rotation.sin + angle * rotation.cos});
}

void takeMass(const World& world, SoftObstacle& obstacle) {
    const std::uint8_t flags = world.bodies.info[obstacle.body].flags;
    const BodyMass& mass = world.bodies.mass[obstacle.body];
    obstacle.inverseMass = {(flags & kLockX) != 0 ? 0.0f : mass.inverseMass,
                            (flags & kLockY) != 0 ? 0.0f : mass.inverseMass};
    obstacle.inverseInertia = mass.inverseInertia;
}

Vec2 accelerationOf(const StepContext& step, std::uint32_t body) {
    const BodyDrive& drive = step.world.bodies.driveOf(body);
    const Vec2 gravity = step.runs(Effect::Gravity) ? step.world.settings.gravity : Vec2{};
    const std::uint8_t flags = step.world.bodies.info[body].flags;
    const Vec2 sum = drive.gravityScale * gravity + drive.acceleration +
                     step.world.bodies.mass[body].inverseMass * drive.force;
    return {(flags & kLockX) != 0 ? 0.0f : sum.x, (flags & kLockY) != 0 ? 0.0f : sum.y};
}

SoftObstacle foreseen(const StepContext& step, std::uint32_t body) {
    const World& world = step.world;
    const BodyPose& pose = world.bodies.pose[body];
    SoftObstacle obstacle;
    obstacle.body = body;
    obstacle.centre = pose.centre;
    obstacle.rotation = pose.rotation;
    obstacle.localCentre = pose.localCentre;
    obstacle.velocity = world.bodies.motion[body].velocity;
    obstacle.spin = world.bodies.motion[body].angularVelocity;
    if (!isPushed(world, body)) return obstacle;
    obstacle.rests = world.bodies.info[body].place == kNone;
    if (obstacle.rests) return obstacle;
    takeMass(world, obstacle);
    obstacle.acceleration = accelerationOf(step, body);
    return obstacle;
}

void addObstacle(const StepContext& step, std::vector<SoftObstacle>& all, std::uint32_t body) {
    const auto at = std::lower_bound(all.begin(), all.end(), body, isBefore);
    if (at == all.end() || at->body != body) all.insert(at, foreseen(step, body));
}

bool isAmong(const std::vector<SoftObstacle>& all, std::uint32_t body) {
    const auto at = std::lower_bound(all.begin(), all.end(), body, isBefore);
    return at != all.end() && at->body == body;
}

SoftSupport supportOf(const Contact& contact, const std::vector<SoftObstacle>& all) {
    const auto find = [&](std::uint32_t body) {
        return static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), body, isBefore) -
                                          all.begin());
    };
    SoftSupport support;
    support.a = find(contact.bodyA);
    support.b = find(contact.bodyB);
    support.normal = contact.normal;
    support.points = contact.count;
    support.friction = contact.friction;
    support.surfaceSpeed = contact.surfaceSpeed;
    for (std::uint32_t i = 0; i < contact.count; ++i) {
        support.armA[i] = rotate(all[support.a].rotation, contact.anchors[i].a);
        support.armB[i] = rotate(all[support.b].rotation, contact.anchors[i].b);
        support.gap[i] = std::max(0.0f, i == 0 ? contact.separation0 : contact.separation1);
    }
    return support;
}

/// Contacts of obstacles with static or kinematic bodies and with each other. Other bodies are too far away.
void findSupports(const StepContext& step, SoftSurroundings& around) {
    const World& world = step.world;
    std::vector<SoftObstacle>& all = around.obstacles;
    const auto holds = [&](std::uint32_t body, std::uint32_t other) {
        return isPushed(world, body) && isAmong(all, body) &&
               (!isPushed(world, other) || isAmong(all, other));
    };
    const auto isSupport = [&](const Contact& contact) {
        return holds(contact.bodyA, contact.bodyB) || holds(contact.bodyB, contact.bodyA);
    };
    around.supports.clear();
    for (const std::uint32_t i : around.contacts) {
        const Contact& contact = world.contacts[i];
        if (!isSupport(contact)) continue;
        addObstacle(step, all, contact.bodyA);
        addObstacle(step, all, contact.bodyB);
    }
    for (const std::uint32_t i : around.contacts) {
        if (isSupport(world.contacts[i])) around.supports.push_back(supportOf(world.contacts[i], all));
    }
}

/// @param push  kg m
void deltaPosition(SoftObstacle& obstacle, Vec2 arm, Vec2 push, float h) {
    const Vec2 displacement{obstacle.inverseMass.x * push.x, obstacle.inverseMass.y * push.y};
    const float turn = obstacle.inverseInertia * cross(arm, push);
    obstacle.moved += displacement;
    obstacle.turned += turn;
    obstacle.centre = obstacle.centre + displacement;
    obstacle.rotation = turnedBy(obstacle.rotation, turn);
    obstacle.velocity += displacement / h;
    obstacle.spin += turn / h;
}

void hold(SoftSupport& support, SoftObstacle& a, SoftObstacle& b, float h) {
    const Vec2 along = perpendicular(support.normal);
    for (std::uint32_t i = 0; i < support.points; ++i) {
        const Vec2 armA = support.armA[i], armB = support.armB[i];
        const Vec2 displacement = b.displacement(armB) - a.displacement(armA);
        const float depth = -(support.gap[i] + dot(displacement, support.normal));
        const float weight = a.weight(armA, support.normal) + b.weight(armB, support.normal);
        if (!(depth > 0.0f) || !(weight > 0.0f)) continue;
        const float push = depth / weight, maximum = support.friction * push;
        const float slid = dot(displacement, along) - support.surfaceSpeed * h;
        const float rub =
            std::clamp(slid / (a.weight(armA, along) + b.weight(armB, along)), -maximum, maximum);
        const Vec2 impulse = push * support.normal - rub * along;
        deltaPosition(a, armA, -impulse, h);
        deltaPosition(b, armB, impulse, h);
    }
}

}  // namespace

SoftObstacle& SoftSurroundings::obstacleOf(std::uint32_t body) {
    return *std::lower_bound(obstacles.begin(), obstacles.end(), body, isBefore);
}

void findSurroundings(StepContext& step) {
    SoftSurroundings& around = step.work.softSurroundings;
    around.shapes.clear();
    around.ends.clear();
    around.pushes.clear();
    for (const SoftBody& body : step.world.softBodies.all) {
        if (body.isAlive) findShapes(step, body);
        around.ends.push_back(static_cast<std::uint32_t>(around.shapes.size()));
    }
    findNeighbours(step.world, around);
    findContacts(step.world, around);
}

void foresee(StepContext& step, std::span<const std::uint32_t> group) {
    SoftSurroundings& around = step.work.softSurroundings;
    around.obstacles.clear();
    for (const std::uint32_t soft : group) {
        for (const std::uint32_t shape : around.shapesOf(soft))
            addObstacle(step, around.obstacles, step.world.shapes.info[shape].body);
    }
    findSupports(step, around);
}

void moveObstacles(SoftSurroundings& around, float h) {
    for (SoftObstacle& o : around.obstacles) {
        o.velocity += h * o.acceleration;
        o.moved = h * o.velocity;
        o.turned = h * o.spin;
        o.centre = o.centre + o.moved;
        if (o.turned != 0.0f) o.rotation = turnedBy(o.rotation, o.turned);
    }
}

void pushObstacle(SoftObstacle& obstacle, Vec2 arm, Vec2 push, float h, float left) {
    if (obstacle.inverseMass == Vec2{} && obstacle.inverseInertia == 0.0f) return;
    const Vec2 velocity = obstacle.velocity;
    const float spin = obstacle.spin;
    deltaPosition(obstacle, arm, push, h);
    obstacle.gained += obstacle.velocity - velocity;
    obstacle.spun += obstacle.spin - spin;
    obstacle.early += left * (obstacle.velocity - velocity);
    obstacle.earlySpun += left * (obstacle.spin - spin);
}

void holdObstacles(SoftSurroundings& around, float h) {
    for (SoftSupport& support : around.supports) {
        SoftObstacle &a = around.obstacles[support.a], &b = around.obstacles[support.b];
        hold(support, a, b, h);
    }
    for (SoftSupport& support : around.supports) {
        const SoftObstacle &a = around.obstacles[support.a], &b = around.obstacles[support.b];
        for (std::uint32_t i = 0; i < support.points; ++i) {
            const Vec2 displacement = b.displacement(support.armB[i]) - a.displacement(support.armA[i]);
            support.gap[i] = std::max(0.0f, support.gap[i] + dot(displacement, support.normal));
        }
    }
}

void rouse(const StepContext& step, SoftObstacle& obstacle) {
    wake(step.world, obstacle.body);
    obstacle.rests = false;
    takeMass(step.world, obstacle);
}

/// A change of velocity and a constant acceleration that together give the predicted position and velocity.
/// In the solver, gravity and supports act against the acceleration, whereas a change of velocity alone would
/// lift resting bodies, step by step.
void pushBodies(StepContext& step) {
    for (const SoftObstacle& o : step.work.softSurroundings.obstacles) {
        if (o.gained == Vec2{} && o.spun == 0.0f) continue;
        const Vec2 steady = 2.0f * (o.gained - o.early);
        const float steadySpin = 2.0f * (o.spun - o.earlySpun);
        BodyMotion& motion = step.world.bodies.motion[o.body];
        motion.velocity += o.gained - steady;
        motion.angularVelocity += o.spun - steadySpin;
        step.work.softSurroundings.pushes.push_back({o.body, steady / step.dt, steadySpin / step.dt});
    }
}

}  // namespace plumb::physics
