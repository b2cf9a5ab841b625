#include "physics/contacts/contacts.hpp"

#include <algorithm>

#include "physics/broadphase/overlap.hpp"
#include "physics/kernels.hpp"
#include "physics/narrowphase/axis_aligned_boxes.hpp"
#include "physics/narrowphase/reference_face.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// Pose of body B relative to the centre of mass of body A.
struct Encounter {
    Rot rotationA;
    Rot relativeRotation;  // B's rotation relative to A
    Vec2 between;          // m: from A's centre of mass to B's, in A's frame
};

Encounter encounterOf(const BodyPose& a, const BodyPose& b) {
    return {a.rotation, between(a.rotation, b.rotation), unrotate(a.rotation, b.centre - a.centre)};
}

/// Predicts the relative pose after `time` (s) at constant velocities.
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
    return dot(normalInA, now.between + rotate(now.relativeRotation, anchors.b) - anchors.a);
}

/// True if the bodies have hardly moved relative to each other since the points were computed.
/// @param normal  the contact's normal, in A's current frame
bool hardlyMoved(const Contact& contact, const Encounter& now, Vec2 normal, float tolerance) {
    if (std::fabs(cross(contact.normalInA, normal)) > kMaxTurn) return false;
    const float turned = contact.relativeRotation.cos * now.relativeRotation.sin -
                         contact.relativeRotation.sin * now.relativeRotation.cos;
    const ContactAnchors& first = contact.anchors[0];
    const float arm = largestOf(first.b) + largestOf(contact.anchors[1].b) + largestOf(first.a);
    if (std::fabs(turned) * arm > tolerance) return false;
    const Vec2 apart = now.between + rotate(now.relativeRotation, first.b) - first.a;
    return std::fabs(cross(normal, apart)) <= tolerance;
}

/// Reuses the points of the last step: updates their separations, but keeps the world directions of the
/// normal and the arms (see prepare() of the kernels). So a slightly tilted column carries loads like an
/// upright one, and high stacks do not buckle on their contacts, which are springs.
/// @return false if the points must be recomputed
bool recycle(Contact& contact, const Encounter& now, const Settings& settings) {
    // Only for contacts with forces: without them a body could pass through the other along the normal.
    if ((contact.flags & (kTouching | kRound | kTriggered | kPassing | kDisabled)) != kTouching) return false;
    const int all = (contact.flags & kUnturned) != 0 ? 1 : 2;
    if (contact.count > all) return false;
    const float size = std::min(largestOf(contact.anchors[0].a), largestOf(contact.anchors[0].b));
    const float maximum = std::min(settings.recycleDistance, kMaxOfSize * size);  // smaller for small bodies
    // With one point out of two, the second may be about to touch: use a smaller tolerance.
    const float tolerance = contact.count == all ? maximum : kOnePointPart * maximum;
    const Vec2 normal = unrotate(now.rotationA, contact.normal);
    if (!hardlyMoved(contact, now, normal, tolerance)) return false;
    const float separation0 = separationOf(now, contact.anchors[0], normal);
    if (separation0 > settings.slop) return false;
    contact.separation0 = separation0;
    if (contact.count == 2) contact.separation1 = separationOf(now, contact.anchors[1], normal);
    return true;
}

/// Stores a manifold that was computed in the frame of A's shapes.
void takeManifold(const World& world, Contact& contact, const Manifold& manifold, const Encounter& now) {
    const auto impulseOf = [count = contact.count, first = contact.ids[0], impulse0 = contact.impulse0,
                            second = contact.ids[1], impulse1 = contact.impulse1](std::uint16_t id) {
        if (count > 0 && first == id) return impulse0;
        return count > 1 && second == id ? impulse1 : 0.0f;
    };
    contact.count = static_cast<std::uint8_t>(manifold.count);
    contact.relativeRotation = now.relativeRotation;
    contact.normalInA = manifold.normal;
    contact.normal = rotate(now.rotationA, manifold.normal);
    contact.roundA = manifold.roundA;
    contact.roundB = manifold.roundB;
    for (int i = 0; i < 2; ++i) {
        const ManifoldPoint& point = manifold.points[std::min(i, manifold.count - 1)];
        const Vec2 middle = point.point - world.bodies.pose[contact.bodyA].localCentre;
        const Vec2 halfway = (0.5f * point.separation) * manifold.normal;
        contact.anchors[i] = {middle - halfway,
                              unrotate(now.relativeRotation, middle + halfway - now.between)};
        contact.ids[i] = point.id;
    }
    contact.separation0 = manifold.points[0].separation;
    contact.impulse0 = impulseOf(contact.ids[0]);
    contact.separation1 = manifold.count == 2 ? manifold.points[1].separation : kFarAway;
    contact.impulse1 = manifold.count == 2 ? impulseOf(contact.ids[1]) : 0.0f;
}

Frame frameInA(const World& world, const Contact& contact, const Encounter& now) {
    const BodyPose& a = world.bodies.pose[contact.bodyA];
    const BodyPose& b = world.bodies.pose[contact.bodyB];
    return {a.localCentre + now.between - rotate(now.relativeRotation, b.localCentre), now.relativeRotation};
}

/// Keeps only the deepest point: without rotation both points approach at the same speed.
void keepDeepest(Manifold& manifold) {
    if (manifold.count < 2) return;
    if (manifold.points[1].separation < manifold.points[0].separation)
        manifold.points[0] = manifold.points[1];
    manifold.count = 1;
}

/// True if a bullet is so fast that its sweep will detect the hit in this step. The sweep finds the time of
/// impact, while the solver would stop the bullet at the surface for the rest of the step.
bool isLeftToSweep(const World& world, const Contact& contact, const Manifold& manifold,
                   const Encounter& now) {
    if ((contact.flags & (kTouching | kTriggered)) != 0 || !world.settings.continuous) return false;
    const auto isBullet = [&](std::uint32_t body) { return (world.bodies.info[body].flags & kBullet) != 0; };
    const bool isB = (contact.flags & kFixedA) != 0 || isBullet(contact.bodyB);
    if (!isB && !isBullet(contact.bodyA)) return false;
    const std::uint32_t swept = isB ? contact.bodyB : contact.bodyA;
    float gap = manifold.points[0].separation;
    if (manifold.count == 2) gap = std::min(gap, manifold.points[1].separation);
    if (gap <= kSweptGap + 4.0f * kTouchDistance) return false;
    const std::vector<BodyMotion>& motion = world.bodies.motion;
    const Vec2 speed = motion[contact.bodyB].velocity - motion[contact.bodyA].velocity;
    const float closing =
        std::min(-dot(rotate(now.rotationA, manifold.normal), speed), length(motion[swept].velocity));
    // It is swept, and its core would pass the surface.
    return closing * world.stepLength > gap + kSweptCore * world.bodies.info[swept].reach;
}

/// Stores the result of the narrow phase in the contact.
void take(const World& world, Contact& contact, const Encounter& now, Manifold manifold,
          DetectionCounts& counts) {
    if ((contact.flags & kUnturned) != 0) keepDeepest(manifold);
    if (manifold.count == 0 || isLeftToSweep(world, contact, manifold, now)) {
        ++counts.apartByAxes;
        clearPoints(contact);
        return;
    }
    ++counts.touching;
    takeManifold(world, contact, manifold, now);
    if ((contact.flags & kTouching) == 0) return markInitialOverlap(world, contact);
    if ((contact.flags & kInitialOverlap) != 0) hideInitialOverlap(world, contact);
}

/// Computes the contact of a round shape at the middle of the step. While a round shape rolls, its contact
/// point moves and the normal rotates, but a step uses a single direction. With the direction at the start, a
/// body that rocks on a round one would gain energy, and piles with balls would never come to rest.
/// @return false if by then it no longer touches there, or touches another feature, as at a seam
bool takeHalfway(const World& world, Contact& contact, const Encounter& now, float halfStep,
                 DetectionCounts& counts) {
    const Geometry& a = world.shapes.geometry[contact.shapeA];
    const Geometry& b = world.shapes.geometry[contact.shapeB];
    if ((contact.flags & (kTouching | kTriggered)) != kTouching || contact.count != 1) return false;
    if (!(a.radius + b.radius > 0.0f)) return false;
    const Encounter then = ahead(world, contact, halfStep);
    const Manifold manifold = collide(a, b, world.shapes.corners, frameInA(world, contact, then),
                                      world.settings.speculativeDistance);
    if (manifold.count != 1 || manifold.points[0].id != contact.ids[0] ||
        dot(manifold.normal, contact.normalInA) < kMinCosine)
        return false;
    ++counts.touching;
    takeManifold(world, contact, manifold, then);
    // A round feature can rotate in place: only its center moves with the body.
    const ContactAnchors centers{
        contact.anchors[0].a - contact.roundA * manifold.normal,
        contact.anchors[0].b + contact.roundB * unrotate(then.relativeRotation, manifold.normal)};
    contact.separation0 =
        separationOf(now, centers, unrotate(now.rotationA, contact.normal)) - contact.roundA - contact.roundB;
    if ((contact.flags & kInitialOverlap) != 0) hideInitialOverlap(world, contact);
    return true;
}

/// Two axis-aligned boxes.
struct AxisAlignedPair {
    const Geometry& a;
    const Geometry& b;
    Vec2 between;       // m: from A's centre of mass to B's
    Vec2 displacement;  // m: from the middle of box A to that of box B
};

AxisAlignedPair uprightPairOf(const World& world, const Contact& contact) {
    const BodyPose& poseA = world.bodies.pose[contact.bodyA];
    const BodyPose& poseB = world.bodies.pose[contact.bodyB];
    const Geometry& a = world.shapes.geometry[contact.shapeA];
    const Geometry& b = world.shapes.geometry[contact.shapeB];
    const Vec2 between = poseB.centre - poseA.centre;
    return {a, b, between, between + (b.a - poseB.localCentre) - (a.a - poseA.localCentre)};
}

Manifold manifoldOf(const World& world, const AxisAlignedPair& pair) {
    Manifold manifold =
        collideUpright(pair.a.b, pair.b.b, pair.displacement, world.settings.speculativeDistance);
    manifold.points[0].point += pair.a.a;
    return manifold;
}

/// Fast path while the same two faces touch: updates only the separation. pointOf() computes the point.
bool slideUpright(Contact& contact, const AxisAlignedPair& pair, float speculative) {
    if ((contact.flags & (kTouching | kTriggered)) != kTouching || contact.count != 1) return false;
    const Vec2 gap = gapOf(pair.a.b, pair.b.b, pair.displacement);
    if (std::max(gap.x, gap.y) > speculative || std::min(gap.x, gap.y) > 0.0f) return false;
    const bool alongY = goesAlongY(pair.a.b, pair.b.b, gap);
    const Vec2 normal = alongY ? Vec2{0.0f, pair.displacement.y < 0.0f ? -1.0f : 1.0f}
                               : Vec2{pair.displacement.x < 0.0f ? -1.0f : 1.0f, 0.0f};
    if (!(normal == contact.normal)) return false;
    contact.separation0 = alongY ? gap.y : gap.x;
    return true;
}

void noteRecycled(const World& world, Contact& contact, DetectionCounts& counts) {
    ++counts.recycled;
    ++counts.touching;
    if ((contact.flags & kInitialOverlap) != 0) hideInitialOverlap(world, contact);
}

/// True if the bounds no longer overlap, which ends the contact.
bool endsByBounds(const World& world, Contact& contact, DetectionCounts& counts) {
    if (touch(world.shapes.bounds[contact.shapeA], world.shapes.bounds[contact.shapeB])) return false;
    ++counts.apartByBounds;
    contact.flags |= kGone;
    return true;
}

/// Performs the narrow phase for two boxes that stay axis-aligned.
void touchUpright(const World& world, Contact& contact, DetectionCounts& counts) {
    const AxisAlignedPair pair = uprightPairOf(world, contact);
    if (slideUpright(contact, pair, world.settings.speculativeDistance))
        return noteRecycled(world, contact, counts);
    const Manifold manifold = manifoldOf(world, pair);
    if (manifold.count == 0 && endsByBounds(world, contact, counts)) return;
    take(world, contact, {{}, {}, pair.between}, manifold, counts);
}

/// True if no test of outlines is needed: points reused, contact ended or bodies too far apart.
bool isSettled(const World& world, Contact& contact, const Encounter& now, DetectionCounts& counts) {
    if (recycle(contact, now, world.settings)) {
        noteRecycled(world, contact, counts);
        return true;
    }
    if (endsByBounds(world, contact, counts)) return true;
    const float reach = world.bodies.info[contact.bodyA].reach + world.bodies.info[contact.bodyB].reach +
                        world.settings.speculativeDistance;
    if ((contact.flags & kFixedA) == 0 && !(lengthSquared(now.between) <= reach * reach)) {
        ++counts.apartByCircles;
        clearPoints(contact);
        return true;
    }
    return false;
}

/// Collects pairs of boxes and collides eight of them at once.
class BoxBatch {
public:
    BoxBatch(const World& world, DetectionCounts& counts) : world_{world}, counts_{counts} {}

    void add(Contact& contact, const Encounter& now, const Geometry& a, const Geometry& b) {
        contacts_[count_] = &contact;
        encounters_[count_] = now;
        putPair(pairs_, count_, a, b, frameInA(world_, contact, now));
        if (++count_ == kLanes) finish();
    }

    void finish() {
        if (count_ == 0) return;
        kernels_.collideBoxes(pairs_, world_.settings.speculativeDistance, touches_);
        for (int i = 0; i < count_; ++i) {
            const Geometry& a = world_.shapes.geometry[contacts_[i]->shapeA];
            take(world_, *contacts_[i], encounters_[i], manifoldOf(touches_, i, a), counts_);
        }
        count_ = 0;
    }

private:
    const World& world_;
    DetectionCounts& counts_;
    const SolverKernels& kernels_ = solverKernels();
    Contact* contacts_[kLanes] = {};
    Encounter encounters_[kLanes];
    BoxPairs pairs_{};  // lanes without a pair have old values and are ignored
    BoxTouches touches_;
    int count_ = 0;
};

/// True if the shape is axis-aligned and only a setter can rotate its body.
bool staysUpright(const World& world, std::uint32_t body, const Geometry& outline) {
    return world.bodies.info[body].kind != BodyKind::Kinematic && outline.kind == ShapeKind::Box &&
           outline.radius == 0.0f && outline.rotation == Rot{} && world.bodies.pose[body].rotation == Rot{};
}

constexpr std::size_t kAhead = 4;  // contacts: prefetch distance

/// Prefetches the bodies and shapes of later contacts, which are scattered in memory. Always inlined, because
/// GCC removes calls of a function that only prefetches.
[[gnu::always_inline]] inline void fetchAhead(const World& world, std::span<const Contact> contacts,
                                              std::size_t i) {
    const Shapes& shapes = world.shapes;
    if (i + kAhead >= contacts.size()) return;
    for (const std::uint32_t shape : {contacts[i + kAhead].shapeA, contacts[i + kAhead].shapeB}) {
        const Geometry& outline = shapes.geometry[shape];
        if (outline.kind != ShapeKind::Polygon) continue;
        __builtin_prefetch(&shapes.corners[outline.first]);
        __builtin_prefetch(&shapes.corners[outline.first + outline.count - 1u]);
    }
    const Contact& later = contacts[std::min(i + 2 * kAhead, contacts.size() - 1)];
    for (const std::uint32_t shape : {later.shapeA, later.shapeB}) {
        __builtin_prefetch(&shapes.bounds[shape]);
        __builtin_prefetch(&shapes.geometry[shape]);
    }
    for (const std::uint32_t body : {later.bodyA, later.bodyB}) {
        __builtin_prefetch(&world.bodies.pose[body]);
        __builtin_prefetch(&world.bodies.info[body].reach);
    }
}

}  // namespace

void copyMaterials(const World& world, Contact& contact) {
    const ShapeInfo& a = world.shapes.info[contact.shapeA];
    const ShapeInfo& b = world.shapes.info[contact.shapeB];
    const Geometry& outlineA = world.shapes.geometry[contact.shapeA];
    const Geometry& outlineB = world.shapes.geometry[contact.shapeB];
    contact.friction = std::sqrt(a.friction * b.friction);
    contact.bounciness = std::max(a.bounciness, b.bounciness);
    const ShapeExtras& moreA = world.shapes.extras[a.extras];
    const ShapeExtras& moreB = world.shapes.extras[b.extras];
    contact.rollingResistance = std::max(moreA.rollingResistance, moreB.rollingResistance) *
                                std::max(outlineA.radius, outlineB.radius);
    contact.surfaceSpeed = moreA.surfaceSpeed + moreB.surfaceSpeed;
    const bool triggered = ((a.flags | b.flags) & kTrigger) != 0;
    const bool reports = ((a.flags | b.flags) & kReportsContacts) != 0;
    const bool fixed = !isDynamic(world, contact.bodyA);
    const bool unturned = !canRotate(world, contact.bodyA) && !canRotate(world, contact.bodyB);
    const bool upright = unturned && staysUpright(world, contact.bodyA, outlineA) &&
                         staysUpright(world, contact.bodyB, outlineB);
    if (contact.friction == 0.0f) contact.frictionImpulse = 0.0f;
    const int kept = contact.flags & (kTouching | kBegan | kDisabled | kPassing | kInitialOverlap);
    contact.flags = static_cast<std::uint16_t>(
        kept | (triggered ? kTriggered : 0) | (reports ? kReports : 0) |
        ((a.flags & kOneWay) != 0 ? kOneWayA : 0) | ((b.flags & kOneWay) != 0 ? kOneWayB : 0) |
        (fixed ? kFixedA : 0) |
        (outlineA.kind == ShapeKind::Circle || outlineB.kind == ShapeKind::Circle ? kRound : 0) |
        (unturned ? kUnturned : 0) | (upright ? kAlongAxes : 0));
}

bool needsContact(const World& world, std::uint32_t shapeA, std::uint32_t shapeB) {
    const Shapes& shapes = world.shapes;
    const auto isStopped = [&](const ShapeExtras& border, const Filter& other) {
        return (border.frontLayers & other.mask) != 0 && (border.frontMask & other.layers) != 0;
    };
    const BodyInfo& a = world.bodies.info[shapes.info[shapeA].body];
    const BodyInfo& b = world.bodies.info[shapes.info[shapeB].body];
    if (a.kind != BodyKind::Dynamic || b.kind != BodyKind::Dynamic) {
        // Two bodies that are not dynamic have contacts only with triggers, and one of them must be awake.
        const bool trigger = ((shapes.info[shapeA].flags | shapes.info[shapeB].flags) & kTrigger) != 0;
        const bool pushed = a.kind == BodyKind::Dynamic || b.kind == BodyKind::Dynamic;
        const bool someAwake = a.awakeIndex != kNone || b.awakeIndex != kNone;
        if (!(pushed ? trigger || someAwake : trigger && someAwake)) return false;
    }
    return !isStopped(shapes.extrasOf(shapeA), shapes.filter[shapeB]) &&
           !isStopped(shapes.extrasOf(shapeB), shapes.filter[shapeA]);
}

Contact makeContact(const World& world, std::uint32_t shapeA, std::uint32_t shapeB) {
    Contact contact;
    const std::uint32_t bodyA = world.shapes.info[shapeA].body, bodyB = world.shapes.info[shapeB].body;
    const bool fixedB = !isDynamic(world, bodyB);
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
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Contact& contact = contacts[i];
        fetchAhead(world, contacts, i);
        ++counts.pairs;
        contact.flags &= static_cast<std::uint16_t>(~(kBegan | kGone));
        const Encounter now = encounterOf(world.bodies.pose[contact.bodyA], world.bodies.pose[contact.bodyB]);
        const bool alongAxes = (contact.flags & kAlongAxes) != 0;
        const bool settled = !alongAxes && isSettled(world, contact, now, counts);
        contact.flags &= static_cast<std::uint16_t>(~kDisabled);  // flag of the last step
        if (alongAxes) touchUpright(world, contact, counts);
        if (settled || alongAxes) continue;
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

void touchFaceOnly(const World& world, Contact& contact, const OnlyFace& face) {
    const Encounter now = encounterOf(world.bodies.pose[contact.bodyA], world.bodies.pose[contact.bodyB]);
    const Geometry& a = world.shapes.geometry[contact.shapeA];
    const Geometry& b = world.shapes.geometry[contact.shapeB];
    const Convex convexA = convexOf(a, world.shapes.corners), convexB = convexOf(b, world.shapes.corners);
    MovedCorners moved;
    const Side sideB = moved.moved(convexB, frameInA(world, contact, now));
    Manifold manifold = touchFace(sideOf(convexA), faceAgainst(convexA.corners(), -face.normal), sideB,
                                  face.distance, face.beyond);
    if (a.kind == ShapeKind::Box && b.kind == ShapeKind::Box) {  // corner numbers as in BoxTouchOf::id
        for (ManifoldPoint& point : manifold.points)
            point.id = static_cast<std::uint16_t>(point.id ^ (point.id >> 1 & 0x0101));
    }
    DetectionCounts counts;  // unused: this contact was counted before
    take(world, contact, now, manifold, counts);
}

void findTouch(const World& world, Contact& contact, float distance) {
    const Encounter now = encounterOf(world.bodies.pose[contact.bodyA], world.bodies.pose[contact.bodyB]);
    Manifold manifold = collide(world.shapes.geometry[contact.shapeA], world.shapes.geometry[contact.shapeB],
                                world.shapes.corners, frameInA(world, contact, now), distance);
    if ((contact.flags & kUnturned) != 0) keepDeepest(manifold);
    contact.count = 0;
    if (manifold.count > 0) takeManifold(world, contact, manifold, now);
}

Vec2 pointOf(const World& world, const Contact& contact, int point) {
    if ((contact.flags & kAlongAxes) != 0) {
        const Manifold manifold = manifoldOf(world, uprightPairOf(world, contact));
        const ManifoldPoint& found = manifold.points[0];
        if (manifold.count > 0)
            return found.point - (0.5f * found.separation) * manifold.normal -
                   world.bodies.pose[contact.bodyA].localCentre;
    }
    return contact.anchors[point].a;
}

}  // namespace plumb::physics
