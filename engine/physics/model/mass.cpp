#include <algorithm>

#include "physics/edits.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// Returns the total mass properties of all shapes, in the body's frame.
MassProperties sumOfShapes(const World& world, std::uint32_t body) {
    const Shapes& shapes = world.shapes;
    MassProperties sum;
    Vec2 moment;
    float aboutOrigin = 0.0f;
    forShapesOf(world, body, [&](std::uint32_t s) {
        if (shapes.info[s].density == 0.0f) return;
        const MassProperties own = massProperties(shapes.geometry[s], shapes.corners, shapes.info[s].density);
        sum.mass += own.mass;
        moment += own.mass * own.centre;
        aboutOrigin += own.inertia + own.mass * lengthSquared(own.centre);
    });
    if (sum.mass == 0.0f) return {};
    sum.centre = moment / sum.mass;
    sum.inertia = std::max(aboutOrigin - sum.mass * lengthSquared(sum.centre), 0.0f);
    return sum;
}

constexpr float kMinInertia = 1.0e-20f;  // kg m2: the inverse of a smaller one is too large for the solver

void setMassOf(BodyMass& mass, const MassProperties& sum, const BodyInfo& info) {
    const float ofShapes = sum.mass > 0.0f ? sum.mass : 1.0f;
    mass.mass = std::max(kLightest, (info.owned & kSetMass) != 0 ? mass.mass : ofShapes);
    if ((info.owned & kSetMassData) == 0)
        mass.inertia = sum.mass > 0.0f ? sum.inertia * (mass.mass / sum.mass) : 0.0f;
    mass.inverseMass = 1.0f / mass.mass;
    const bool turns = mass.inertia > 0.0f && (info.flags & kFixedRotation) == 0;
    mass.inverseInertia = turns ? 1.0f / std::max(mass.inertia, kMinInertia) : 0.0f;
}

/// Updates the anchors of joints, which are relative to the center of mass.
void updateJoints(World& world, std::uint32_t body) {
    const Vec2 centre = world.bodies.pose[body].localCentre;
    forJointsOf(world, body, [&](std::uint32_t j) {
        Joint& joint = world.joints.hot[j];
        const JointDefinition& definition = world.joints.definition[j];
        const bool isA = joint.bodyA == body;
        (isA ? joint.anchorA : joint.anchorB) = (isA ? definition.anchorA : definition.anchorB) - centre;
        world.work.get().joints.trees.stale = true;
    });
}

void updateExtent(World& world, std::uint32_t body) {
    const Shapes& shapes = world.shapes;
    BodyInfo& info = world.bodies.info[body];
    const Vec2 centre = world.bodies.pose[body].localCentre;
    info.reach = 0.0f;
    info.core = 0.0f;
    for (std::uint32_t s = info.firstShape; s != kNone; s = shapes.info[s].next) {
        info.reach = std::max(info.reach, reachOf(shapes.geometry[s], shapes.corners, centre));
        info.core = std::max(info.core, coreOf(shapes.geometry[s], shapes.corners, centre));
    }
}

/// Updates contact points, which are relative to the center of mass, so that they stay fixed to the shapes.
void moveAnchors(World& world, std::uint32_t body, Vec2 displacement) {
    if (displacement == Vec2{}) return;
    for (std::vector<Contact>* contacts : {&world.contacts, &world.sleepers.contacts}) {
        for (Contact& contact : *contacts) {
            for (ContactAnchors& anchors : contact.anchors) {
                if (contact.bodyA == body) anchors.a -= displacement;
                if (contact.bodyB == body) anchors.b -= displacement;
            }
        }
    }
}

}  // namespace

void moveCentre(World& world, std::uint32_t body, Vec2 centre) {
    BodyPose& pose = world.bodies.pose[body];
    BodyMotion& motion = world.bodies.motion[body];
    const BodyInfo& info = world.bodies.info[body];
    const bool mayTouch = info.reach > 0.0f && info.firstShape != kNone;  // it had shapes, and has some now
    if (mayTouch) moveAnchors(world, body, centre - pose.localCentre);
    const Vec2 displacement = rotate(pose.rotation, centre - pose.localCentre);
    pose.centre = pose.centre + displacement;
    pose.localCentre = centre;
    motion.velocity += cross(motion.angularVelocity, displacement);
}

void updateMass(World& world, std::uint32_t body) {
    const BodyInfo& info = world.bodies.info[body];
    BodyMass& mass = world.bodies.mass[body];
    if (info.kind != BodyKind::Dynamic) {
        mass = {};
        if (world.bodies.pose[body].localCentre != Vec2{}) moveCentre(world, body, {});
    } else {
        const MassProperties sum = sumOfShapes(world, body);
        setMassOf(mass, sum, info);
        if ((info.owned & kSetMassData) == 0) moveCentre(world, body, sum.centre);
    }
    updateJoints(world, body);
    updateExtent(world, body);
}

}  // namespace plumb::physics
