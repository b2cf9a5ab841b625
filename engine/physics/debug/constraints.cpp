#include <algorithm>
#include <numbers>

#include "physics/debug/picture.hpp"
#include "physics/islands/quality.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

constexpr float kFanPart = 0.6f;      // ratio to the arm: radius of the sector that shows a hinge's limits
constexpr float kMinFan = 0.08f;      // m
constexpr float kLargestFan = 0.35f;  // m
constexpr float kTick = 0.1f;         // m: half the length of the ticks at limits
constexpr float kFreeWay = 0.5f;      // m: drawn half length of a slider without limits

/// A joint with its anchors, in m relative to the origin of the canvas.
struct JointPlace {
    const Joint& joint;
    const JointDefinition& definition;
    Vec2 a;
    Vec2 b;
};

void drawTick(const Picture& picture, Vec2 at, Vec2 along) {
    const Vec2 side = kTick * perpendicular(along);
    picture.canvas.line(at - side, at + side, DebugRole::JointLimit);
}

/// Draws the sector of angles that a hinge's limits allow for B's center.
void drawFan(const Picture& picture, const JointPlace& at) {
    const JointLimit& limit = at.definition.limit;
    if (!limit.on) return;
    const bool hasArm = at.joint.anchorB != Vec2{};
    const Vec2 arm = hasArm ? normalized(-at.joint.anchorB) : Vec2{1.0f, 0.0f};
    const Rot zero = picture.pose(at.joint.bodyA).rotation * rotFromAngle(at.definition.referenceAngle) *
                     Rot{arm.x, arm.y};
    const float radius = std::clamp(kFanPart * length(at.joint.anchorB), kMinFan, kLargestFan);
    const Rot from = zero * rotFromAngle(limit.lower), to = zero * rotFromAngle(limit.upper);
    const float angle = std::min(limit.upper - limit.lower, 2.0f * std::numbers::pi_v<float>);
    drawArc(picture.canvas, at.b, radius, from, angle, DebugRole::JointLimit);
    for (const Rot side : {from, to})
        picture.canvas.line(at.b, at.b + radius * Vec2{side.cos, side.sin}, DebugRole::JointLimit);
}

/// Draws the line along which B's anchor moves.
void drawWay(const Picture& picture, const JointPlace& at) {
    const JointLimit& limit = at.definition.limit;
    const Vec2 axis = rotate(picture.pose(at.joint.bodyA).rotation, at.definition.axis);
    const Vec2 from = at.a + (limit.on ? limit.lower : -kFreeWay) * axis;
    const Vec2 to = at.a + (limit.on ? limit.upper : kFreeWay) * axis;
    picture.canvas.line(from, to, DebugRole::JointLimit);
    if (!limit.on) return;
    drawTick(picture, from, axis);
    drawTick(picture, to, axis);
}

/// Draws ticks at the minimum and maximum length of a rod.
void drawReach(const Picture& picture, const JointPlace& at) {
    const Vec2 displacement = at.b - at.a;
    const JointLimit& limit = at.definition.limit;
    if (!limit.on || displacement == Vec2{}) return;
    const Vec2 along = normalized(displacement);
    if (limit.lower > 0.0f) drawTick(picture, at.a + limit.lower * along, along);
    drawTick(picture, at.a + limit.upper * along, along);
}

void drawLimits(const Picture& picture, const JointPlace& at) {
    switch (at.joint.kind) {
        case JointKind::Revolute: return drawFan(picture, at);
        case JointKind::Prismatic:
        case JointKind::Wheel: return drawWay(picture, at);
        case JointKind::Distance: return drawReach(picture, at);
        default: return;
    }
}

/// Draws a line from a body to its anchor, except for static bodies, which may be far away.
void drawArm(const Picture& picture, std::uint32_t body, Vec2 to) {
    if (picture.world.bodies.info[body].kind != BodyKind::Static)
        picture.canvas.line(picture.centre(body), to, DebugRole::Joint);
}

void drawTies(const Picture& picture, const JointPlace& at) {
    DebugCanvas& canvas = picture.canvas;
    const std::uint32_t bodyA = at.joint.bodyA, bodyB = at.joint.bodyB;
    switch (at.joint.kind) {
        case JointKind::Mouse: canvas.line(picture.seen(at.definition.target), at.b, DebugRole::Joint); break;
        case JointKind::Gear:
            canvas.line(picture.centre(bodyA), picture.centre(bodyB), DebugRole::Joint);
            break;
        case JointKind::Pulley: {
            const Vec2 groundA = picture.seen(at.definition.groundA),
                       groundB = picture.seen(at.definition.groundB);
            canvas.line(at.a, groundA, DebugRole::Joint);
            canvas.line(groundA, groundB, DebugRole::Joint);
            canvas.line(groundB, at.b, DebugRole::Joint);
            break;
        }
        default:
            drawArm(picture, bodyA, at.a);
            drawArm(picture, bodyB, at.b);
            canvas.line(at.a, at.b, DebugRole::Joint);
    }
}

template <class Draw>
void forJoints(const Picture& picture, Draw&& draw) {
    const Joints& joints = picture.world.joints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const Joint& joint = joints.hot[j];
        if (joint.bodyA == kNone || !(picture.shows(joint.bodyA) || picture.shows(joint.bodyB))) continue;
        draw(JointPlace{joint, joints.definition[j], picture.place(joint.bodyA, joint.anchorA),
                        picture.place(joint.bodyB, joint.anchorB)});
    }
}

constexpr float kNormalLength = 0.2f;  // m

/// Calls draw(contact, place, impulse) for each point of the contacts that are shown; impulses in N s.
template <class Draw>
void forPoints(const Picture& picture, Draw&& draw) {
    picture.forContacts(false, [&](const Contact& contact) {
        for (int i = 0; i < contact.count; ++i) {
            draw(contact, picture.place(contact.bodyA, pointOf(picture.world, contact, i)),
                 std::fabs(i == 0 ? contact.impulse0 : contact.impulse1));
        }
    });
}

/// Returns the number of substeps of a step, because contacts store the impulse of one substep. Estimated
/// from the quality settings for sleeping bodies and if there is no last step.
float partsOfStep(const Picture& picture, const Contact& contact) {
    const Bodies& bodies = picture.world.bodies;
    const BodyInfo& pushed = bodies.info[contact.bodyB];
    if (const Workspace* work = picture.choice.lastStep; work != nullptr && pushed.awakeIndex != kNone) {
        const std::size_t group = work->groups.size() > 1 ? work->groupOf[contact.bodyB] : 0;
        if (group < work->groups.size()) return static_cast<float>(work->groups[group].substeps);
    }
    const Quality wished = std::max(bodies.info[contact.bodyA].quality, pushed.quality);
    return static_cast<float>(substepsOf(std::max(wished, picture.world.settings.quality)));
}

/// Returns the length (m) of an impulse's arrow: proportional to the acceleration of the lighter body.
float lengthOf(const Picture& picture, const Contact& contact, float impulse) {
    const auto& masses = picture.world.bodies.mass;
    const float lightest = std::max(masses[contact.bodyA].inverseMass, masses[contact.bodyB].inverseMass);
    const float speed = impulse * lightest * partsOfStep(picture, contact);
    return std::clamp(kArrowPerAcceleration * speed / picture.world.stepLength, -kLongestArrow,
                      kLongestArrow);
}

}  // namespace

void drawJoints(const Picture& picture) {
    forJoints(picture, [&](const JointPlace& at) {
        drawLimits(picture, at);
        drawTies(picture, at);
        picture.canvas.circle(at.b, kPointRadius, DebugRole::Joint);
    });
}

void drawJointForces(const Picture& picture) {
    forJoints(picture, [&](const JointPlace& at) {
        const auto& masses = picture.world.bodies.mass;
        const float lightest =
            std::max(masses[at.joint.bodyA].inverseMass, masses[at.joint.bodyB].inverseMass);
        const Vec2 displacement = (kArrowPerAcceleration * lightest) * at.joint.force;
        if (length(displacement) > 0.0f)
            picture.canvas.arrow(at.b, at.b + limited(displacement), DebugRole::JointForce);
    });
}

void drawContacts(const Picture& picture) {
    forPoints(picture, [&](const Contact&, Vec2 place, float) {
        picture.canvas.circle(place, kPointRadius, DebugRole::Contact);
    });
}

void drawNormals(const Picture& picture) {
    forPoints(picture, [&](const Contact& contact, Vec2 place, float) {
        picture.canvas.arrow(place, place + kNormalLength * contact.normal, DebugRole::Normal);
    });
}

void drawImpulses(const Picture& picture) {
    forPoints(picture, [&](const Contact& contact, Vec2 place, float impulse) {
        if (impulse == 0.0f) return;
        const float length = lengthOf(picture, contact, impulse);
        picture.canvas.arrow(place, place + length * contact.normal, DebugRole::Impulse);
    });
}

void drawFriction(const Picture& picture) {
    picture.forContacts(false, [&](const Contact& contact) {
        if (contact.frictionImpulse == 0.0f || contact.count == 0) return;
        Vec2 from;  // the friction impulse is drawn at the mean of the points
        for (int i = 0; i < contact.count; ++i)
            from += picture.place(contact.bodyA, pointOf(picture.world, contact, i));
        from = from / static_cast<float>(contact.count);
        const float length = lengthOf(picture, contact, contact.frictionImpulse);
        picture.canvas.arrow(from, from + length * perpendicular(contact.normal), DebugRole::Friction);
    });
}

}  // namespace plumb::physics
