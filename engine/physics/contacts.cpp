#include "physics/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/narrowphase/collide.hpp"
#include "physics/solver/kernels.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

bool overlap(const AABB& a, const AABB& b) {
    return a.max.x >= b.min.x && a.min.x <= b.max.x && a.max.y >= b.min.y && a.min.y <= b.max.y;
}

/// Both bodies at the moment, B seen from A's centre of mass.
struct Encounter {
    Rot turnA;
    Rot turn;      // B's rotation seen from A
    Vec2 between;  // m: from A's centre to B's, in A's frame
};

Encounter encounterOf(const BodyPose& a, const BodyPose& b) {
    return {a.rotation, between(a.rotation, b.rotation), unrotate(a.rotation, b.centre - a.centre)};
}

/// Both after so many s of going on as they do.
Encounter ahead(const World& world, const Contact& contact, float time) {
    const auto moved = [&](std::uint32_t body) {
        BodyPose pose = world.bodies.pose[body];
        const BodyMotion& motion = world.bodies.motion[body];
        const float angle = time * motion.angularVelocity;
        pose.centre = pose.centre + time * motion.velocity;
        pose.rotation = normalized(Rot{pose.rotation.cos - angle * pose.rotation.sin,
                                       pose.rotation.sin + angle * pose.rotation.cos});
        return pose;
    };
    return encounterOf(moved(contact.bodyA), moved(contact.bodyB));
}

float separationOf(const Encounter& now, const ContactAnchors& anchors, Vec2 normalInA) {
    return dot(normalInA, now.between + rotate(now.turn, anchors.b) - anchors.a);
}

float longest(Vec2 a) { return std::max(std::fabs(a.x), std::fabs(a.y)); }

/// rad, about: a body that has turned by more since the points were found has them found anew. With 0.1
/// boxes that rock on balls are fed by the stale directions and never come to rest.
constexpr float kMostTurn = 0.03f;

/// Ratio to what is about half the size of the smaller body: it has moved far, seen from itself.
constexpr float kMostOfSize = 0.1f;

/// True when the bodies have hardly moved to each other since the points were found.
/// @param normal  the contact's, in A's frame as it is now
bool hardlyMoved(const Contact& contact, const Encounter& now, Vec2 normal, float tolerance) {
    if (std::fabs(cross(contact.normalInA, normal)) > kMostTurn) return false;
    const float turned = contact.turn.cos * now.turn.sin - contact.turn.sin * now.turn.cos;
    const float arm =
        longest(contact.anchors[0].b) + longest(contact.anchors[1].b) + longest(contact.anchors[0].a);
    if (std::fabs(turned) * arm > tolerance) return false;
    const Vec2 apart = now.between + rotate(now.turn, contact.anchors[0].b) - contact.anchors[0].a;
    return std::fabs(cross(normal, apart)) <= tolerance;
}

/// Takes the points along: how far they are apart is new, while the normal and the arms stay as they were in
/// the world (see prepare() of the kernels). So a load does not feel that its column leans a little, and high
/// stacks do not buckle on contacts that are springs.
/// @return false when they have to be found anew
bool recycle(Contact& contact, const Encounter& now, const Settings& settings) {
    // Nothing keeps a body from going through a trigger along the normal, and out on the other side.
    if ((contact.flags & (kTouching | kRound | kTriggered)) != kTouching) return false;
    // Of small things, a small part; and one point says little of what comes next: a second may be about to
    // touch.
    const float size = std::min(longest(contact.anchors[0].a), longest(contact.anchors[0].b));
    const float most = std::min(settings.recycleDistance, kMostOfSize * size);
    const float tolerance = contact.count == 2 ? most : 0.05f * most;
    const Vec2 normal = unrotate(now.turnA, contact.normal);
    if (!hardlyMoved(contact, now, normal, tolerance)) return false;
    const float separation0 = separationOf(now, contact.anchors[0], normal);
    if (separation0 > settings.slop) return false;
    contact.separation0 = separation0;
    if (contact.count == 2) contact.separation1 = separationOf(now, contact.anchors[1], normal);
    return true;
}

/// Impulses of points that were there before.
struct Known {
    std::uint16_t ids[2];
    float impulses[2];
    int count;

    explicit Known(const Contact& contact)
        : ids{contact.ids[0], contact.ids[1]},
          impulses{contact.impulse0, contact.impulse1},
          count{contact.count} {}
    [[nodiscard]] float impulseOf(std::uint16_t id) const {
        for (int i = 0; i < count; ++i) {
            if (ids[i] == id) return impulses[i];
        }
        return 0.0f;
    }
};

void forgetPoints(Contact& contact) {
    contact.count = 0;
    contact.impulse0 = contact.impulse1 = 0.0f;
    contact.frictionImpulse = contact.rollingImpulse = 0.0f;
}

/// Writes the points of a manifold that was found in the frame of A's shapes.
void takeManifold(const World& world, Contact& contact, const Manifold& manifold, const Encounter& now) {
    const Known known{contact};
    const BodyPose& a = world.bodies.pose[contact.bodyA];
    contact.count = static_cast<std::uint8_t>(manifold.count);
    contact.turn = now.turn;
    contact.normalInA = manifold.normal;
    contact.normal = rotate(now.turnA, manifold.normal);
    contact.roundA = manifold.roundA;
    contact.roundB = manifold.roundB;
    for (int i = 0; i < 2; ++i) {
        const ManifoldPoint& point = manifold.points[std::min(i, manifold.count - 1)];
        const Vec2 middle = point.point - a.localCentre;
        const Vec2 halfway = (0.5f * point.separation) * manifold.normal;
        contact.anchors[i] = {middle - halfway, unrotate(now.turn, middle + halfway - now.between)};
        contact.ids[i] = point.id;
    }
    contact.separation0 = manifold.points[0].separation;
    contact.impulse0 = known.impulseOf(contact.ids[0]);
    contact.separation1 = manifold.count == 2 ? manifold.points[1].separation : kFarAway;
    contact.impulse1 = manifold.count == 2 ? known.impulseOf(contact.ids[1]) : 0.0f;
}

Frame frameInA(const World& world, const Contact& contact, const Encounter& now) {
    const BodyPose& a = world.bodies.pose[contact.bodyA];
    const BodyPose& b = world.bodies.pose[contact.bodyB];
    return {a.localCentre + now.between - rotate(now.turn, b.localCentre), now.turn};
}

bool nearByCircles(const World& world, const Contact& contact, const Encounter& now) {
    const float reach = world.bodies.info[contact.bodyA].reach + world.bodies.info[contact.bodyB].reach +
                        world.settings.speculativeDistance;
    return lengthSquared(now.between) <= reach * reach;
}

bool isRound(ShapeKind kind) { return kind == ShapeKind::Circle; }

// Bodies that are put into each other (by a level, a script, a change of size) would be thrown apart. So of
// an overlap that no motion explains, a part is left alone: as deep as it is when it begins, and less and
// less.

constexpr int kEasingShift = 12;
constexpr int kMostEasing = 15;
constexpr int kEasingSteps = 8;        // after which the number is one less
constexpr float kEasingUnit = 0.002f;  // m: overlap left alone is this times the square of the number

/// The number that belongs to an overlap, m.
int easingOf(float depth) {
    return std::min(static_cast<int>(std::sqrt(depth / kEasingUnit)) + 1, kMostEasing);
}

/// How deep what has just begun may be by the motion of the bodies in a step, m, generously.
float reachedByMotion(const World& world, const Contact& contact) {
    constexpr float kLongStep = 1.0f / 30.0f;  // s
    const BodyMotion& a = world.bodies.motion[contact.bodyA];
    const BodyMotion& b = world.bodies.motion[contact.bodyB];
    const float turning = std::fabs(a.angularVelocity) * world.bodies.info[contact.bodyA].reach +
                          std::fabs(b.angularVelocity) * world.bodies.info[contact.bodyB].reach;
    return world.settings.slop + kLongStep * (length(b.velocity - a.velocity) + turning);
}

void noteOverlap(const World& world, Contact& contact) {
    contact.flags &= static_cast<std::uint16_t>(~kEasing);
    if ((contact.flags & (kOneWayA | kOneWayB)) != 0) return;  // what is inside falls through
    const float depth = -std::min(contact.separation0, contact.separation1);
    if (depth <= 2.0f * world.settings.slop || depth <= reachedByMotion(world, contact)) return;
    contact.flags |= static_cast<std::uint16_t>(easingOf(depth) << kEasingShift);
}

/// Hides from the solver what is left alone.
void ease(const World& world, Contact& contact) {
    const auto phase = static_cast<int>(world.steps % kEasingSteps);
    if (phase == 0) contact.flags -= static_cast<std::uint16_t>(1 << kEasingShift);
    const int left = (contact.flags >> kEasingShift) * kEasingSteps - phase;  // falls by 1 a step
    const float number = std::max(static_cast<float>(left) * (1.0f / kEasingSteps), 0.0f);
    const float hidden = kEasingUnit * number * number;
    if (contact.separation0 < 0.0f) contact.separation0 = std::min(contact.separation0 + hidden, 0.0f);
    if (contact.separation1 < 0.0f) contact.separation1 = std::min(contact.separation1 + hidden, 0.0f);
}

/// Takes note of what was found.
void take(const World& world, Contact& contact, const Encounter& now, const Manifold& manifold,
          DetectionCounts& counts) {
    if (manifold.count == 0) {
        ++counts.apartByAxes;
        forgetPoints(contact);
        return;
    }
    ++counts.touching;
    takeManifold(world, contact, manifold, now);
    if ((contact.flags & kTouching) == 0) noteOverlap(world, contact);
    if ((contact.flags & kEasing) != 0) ease(world, contact);
}

/// Where something round touches wanders while it rolls, and the normal turns with it. The step holds on to
/// one direction, so that of its middle is taken: with that of its start, what rocks on something round would
/// swing higher and higher, and piles with balls in them would never come to rest.
/// @return false when it will no longer touch there, or with something else, as at a seam
bool takeHalfway(const World& world, Contact& contact, const Encounter& now, float halfStep,
                 DetectionCounts& counts) {
    constexpr float kLeastCosine = 0.95f;
    const Geometry& a = world.shapes.geometry[contact.shapeA];
    const Geometry& b = world.shapes.geometry[contact.shapeB];
    const bool rolls = contact.count == 1 && a.radius + b.radius > 0.0f;
    if ((contact.flags & (kTouching | kTriggered)) != kTouching || !rolls) return false;
    const Encounter then = ahead(world, contact, halfStep);
    const Manifold manifold = collide(a, b, world.shapes.corners, frameInA(world, contact, then),
                                      world.settings.speculativeDistance);
    if (manifold.count != 1 || manifold.points[0].id != contact.ids[0] ||
        dot(manifold.normal, contact.normalInA) < kLeastCosine)
        return false;
    ++counts.touching;
    takeManifold(world, contact, manifold, then);
    contact.separation0 = separationOf(now, contact.anchors[0], unrotate(now.turnA, contact.normal));
    if ((contact.flags & kEasing) != 0) ease(world, contact);
    return true;
}

/// What can be said without a look at the outlines: still the same, gone, or too far apart.
bool isSettled(const World& world, Contact& contact, const Encounter& now, DetectionCounts& counts) {
    if (recycle(contact, now, world.settings)) {
        ++counts.recycled;
        ++counts.touching;
        if ((contact.flags & kEasing) != 0) ease(world, contact);
        return true;
    }
    if (!overlap(world.shapes.bounds[contact.shapeA], world.shapes.bounds[contact.shapeB])) {
        ++counts.apartByBounds;
        contact.flags |= kGone;
        return true;
    }
    if ((contact.flags & kFixedA) == 0 && !nearByCircles(world, contact, now)) {
        ++counts.apartByCircles;
        forgetPoints(contact);
        return true;
    }
    return false;
}

/// Pairs of boxes, gathered until there are eight of them.
class BoxBatch {
public:
    BoxBatch(const World& world, DetectionCounts& counts) : world_{world}, counts_{counts} {}

    void add(Contact& contact, const Encounter& now, const Geometry& a, const Geometry& b) {
        const Frame bInA = frameInA(world_, contact, now);
        const Vec2 way = unrotate(a.turn, apply(bInA, b.a) - a.a);
        const Rot turn = between(a.turn, bInA.rotation * b.turn);
        contacts_[count_] = &contact;
        encounters_[count_] = now;
        pairs_.halfAx[count_] = a.b.x;
        pairs_.halfAy[count_] = a.b.y;
        pairs_.halfBx[count_] = b.b.x;
        pairs_.halfBy[count_] = b.b.y;
        pairs_.x[count_] = way.x;
        pairs_.y[count_] = way.y;
        pairs_.cosine[count_] = turn.cos;
        pairs_.sine[count_] = turn.sin;
        pairs_.radiusA[count_] = a.radius;
        pairs_.radiusB[count_] = b.radius;
        if (++count_ == kLanes) finish();
    }

    void finish() {
        if (count_ == 0) return;
        kernels_.collideBoxes(pairs_, world_.settings.speculativeDistance, touches_);
        for (int i = 0; i < count_; ++i) take(world_, *contacts_[i], encounters_[i], manifoldOf(i), counts_);
        count_ = 0;
    }

private:
    [[nodiscard]] Manifold manifoldOf(int i) const {
        Manifold manifold;
        if (!(touches_.count[i] > 0.0f)) return manifold;
        const Geometry& a = world_.shapes.geometry[contacts_[i]->shapeA];
        manifold.count = static_cast<int>(touches_.count[i]);
        manifold.normal = rotate(a.turn, {touches_.normalX[i], touches_.normalY[i]});
        manifold.roundA = touches_.roundA[i];
        manifold.roundB = touches_.roundB[i];
        for (int p = 0; p < manifold.count; ++p) {
            manifold.points[p] = {a.a + rotate(a.turn, {touches_.pointX[p][i], touches_.pointY[p][i]}),
                                  touches_.separation[p][i], static_cast<std::uint16_t>(touches_.id[p][i])};
        }
        return manifold;
    }

    const World& world_;
    DetectionCounts& counts_;
    const SolverKernels& kernels_ = solverKernels();
    Contact* contacts_[kLanes] = {};
    Encounter encounters_[kLanes];
    BoxPairs pairs_{};  // lanes that are not used repeat what was there before, which is harmless
    BoxTouches touches_;
    int count_ = 0;
};

}  // namespace

void copyMaterials(const World& world, Contact& contact) {
    const ShapeInfo& a = world.shapes.info[contact.shapeA];
    const ShapeInfo& b = world.shapes.info[contact.shapeB];
    const Geometry& outlineA = world.shapes.geometry[contact.shapeA];
    const Geometry& outlineB = world.shapes.geometry[contact.shapeB];
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.bounciness = std::max(a.bounciness, b.bounciness);
    contact.rollingResistance =
        std::max(a.rollingResistance, b.rollingResistance) * std::max(outlineA.radius, outlineB.radius);
    contact.surfaceSpeed = a.surfaceSpeed + b.surfaceSpeed;
    const bool triggered = ((a.flags | b.flags) & kTrigger) != 0;
    const bool reports = ((a.flags | b.flags) & kReportsContacts) != 0;
    const bool fixed = world.bodies.info[contact.bodyA].kind != BodyKind::Dynamic;
    const int kept = contact.flags & (kTouching | kBegan | kDisabled | kPassing | kEasing);
    contact.flags = static_cast<std::uint16_t>(
        kept | (triggered ? kTriggered : 0) | (reports ? kReports : 0) |
        ((a.flags & kOneWay) != 0 ? kOneWayA : 0) | ((b.flags & kOneWay) != 0 ? kOneWayB : 0) |
        (fixed ? kFixedA : 0) | (isRound(outlineA.kind) || isRound(outlineB.kind) ? kRound : 0) |
        (contact.surfaceSpeed != 0.0f ? kHasSurface : 0));
}

bool comesTo(const World& world, std::uint32_t shapeA, std::uint32_t shapeB) {
    const Shapes& shapes = world.shapes;
    const auto isStopped = [&](const ShapeInfo& border, const Filter& other) {
        return (border.frontLayers & other.mask) != 0 && (border.frontMask & other.layers) != 0;
    };
    const BodyInfo& a = world.bodies.info[shapes.info[shapeA].body];
    const BodyInfo& b = world.bodies.info[shapes.info[shapeB].body];
    if (a.kind != BodyKind::Dynamic || b.kind != BodyKind::Dynamic) {
        // Who cannot be pushed comes to triggers only, and somebody has to be up.
        const bool trigger = ((shapes.info[shapeA].flags | shapes.info[shapeB].flags) & kTrigger) != 0;
        const bool pushed = a.kind == BodyKind::Dynamic || b.kind == BodyKind::Dynamic;
        if ((!pushed && !trigger) || (a.place == kNone && b.place == kNone)) return false;
    }
    return !isStopped(shapes.info[shapeA], shapes.filter[shapeB]) &&
           !isStopped(shapes.info[shapeB], shapes.filter[shapeA]);
}

Contact makeContact(const World& world, std::uint32_t shapeA, std::uint32_t shapeB) {
    Contact contact;
    const std::uint32_t bodyA = world.shapes.info[shapeA].body, bodyB = world.shapes.info[shapeB].body;
    const bool fixedB = world.bodies.info[bodyB].kind != BodyKind::Dynamic;
    contact.shapeA = fixedB ? shapeB : shapeA;
    contact.shapeB = fixedB ? shapeA : shapeB;
    contact.bodyA = fixedB ? bodyB : bodyA;
    contact.bodyB = fixedB ? bodyA : bodyB;
    copyMaterials(world, contact);
    return contact;
}

void findTouches(const World& world, std::span<Contact> contacts, float dt, DetectionCounts& counts) {
    BoxBatch boxes{world, counts};
    const Shapes& shapes = world.shapes;
    for (Contact& contact : contacts) {
        ++counts.pairs;
        const Encounter now = encounterOf(world.bodies.pose[contact.bodyA], world.bodies.pose[contact.bodyB]);
        if (isSettled(world, contact, now, counts)) continue;
        if (takeHalfway(world, contact, now, 0.5f * dt, counts)) continue;
        const Geometry& a = shapes.geometry[contact.shapeA];
        const Geometry& b = shapes.geometry[contact.shapeB];
        if (a.kind == ShapeKind::Box && b.kind == ShapeKind::Box) {
            boxes.add(contact, now, a, b);
        } else {
            take(world, contact, now,
                 collide(a, b, shapes.corners, frameInA(world, contact, now),
                         world.settings.speculativeDistance),
                 counts);
        }
    }
    boxes.finish();
}

std::uint16_t keyOf(const Contact& contact) {
    const bool pushes =
        (contact.flags & (kTouching | kTriggered | kDisabled)) == kTouching && contact.colour <= kOverflow;
    return static_cast<std::uint16_t>((pushes ? int{contact.colour} : int{kKeyIdle}) |
                                      ((contact.flags & kFixedA) != 0 ? kKeyFixed : 0) |
                                      ((contact.flags & kBegan) != 0 ? kKeyBegan : 0));
}

bool isReported(const World& world, const Contact& contact) {
    if ((contact.flags & kPassing) != 0) return false;
    return (contact.flags & kTriggered) != 0 ||
           ((contact.flags & kReports) != 0 && world.manifest.runs(Effect::ContactEvents));
}

ContactEvent eventOf(const World& world, const Contact& contact, ContactPhase phase) {
    const auto bodyId = [&](std::uint32_t body) { return BodyId{body, world.bodies.info[body].generation}; };
    const auto shapeId = [&](std::uint32_t shape) {
        return ShapeId{shape, world.shapes.info[shape].generation};
    };
    const BodyPose& a = world.bodies.pose[contact.bodyA];
    ContactEvent event;
    event.a = bodyId(contact.bodyA);
    event.b = bodyId(contact.bodyB);
    event.shapeA = shapeId(contact.shapeA);
    event.shapeB = shapeId(contact.shapeB);
    event.phase = phase;
    event.isTrigger = (contact.flags & kTriggered) != 0;
    event.normal = contact.normal;
    event.point = toVec2(a.centre + rotate(a.rotation, contact.anchors[0].a));
    event.impulse = std::fabs(contact.impulse0) + std::fabs(contact.impulse1);
    return event;
}

}  // namespace plumb::physics
