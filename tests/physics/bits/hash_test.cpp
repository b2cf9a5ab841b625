#include "core/hash.hpp"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "physics/simulation.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

/// Drops another body into the pit every 150 ticks, so that sleeping bodies wake up.
void disturb(World& world, int tick) {
    if (tick % 150 != 149) return;
    const BodyId body = addBody(world, BodyKind::Dynamic, {-5.0 + 0.05 * (tick % 200), 14.0}, 0.3f);
    static_cast<void>(createShape(world, body, box({0.4f, 0.7f})));
    static_cast<void>(setVelocity(world, body, {1.0f, -12.0f}));
}

/// Builds a world with sleeping bodies, joints, contact events and freed indices.
World makeRich() {
    World world = makePit(40, 5);
    world.settings.sleepTime = 0.2f;
    world.settings.tolerance = 0.002f;
    for (int i = 0; i < 240; ++i) step(world, kTick);
    const BodyId a = addBody(world, BodyKind::Dynamic, {0.0, 20.0}),
                 b = addBody(world, BodyKind::Dynamic, {1.0, 20.0});
    static_cast<void>(createShape(world, a, circle(0.3f)));
    static_cast<void>(createShape(world, b, circle(0.3f)));
    static_cast<void>(createJoint(world, {.a = a, .b = b, .anchorA = {1.0f, 0.0f}}));
    const BodyId c = addBody(world, BodyKind::Dynamic, {3.0, 0.3}),
                 d = addBody(world, BodyKind::Dynamic, {3.0, 0.5});
    static_cast<void>(setDrag(world, c, 0.1f, 0.1f));
    static_cast<void>(createShape(world, c, circle(0.3f), {.rollingResistance = 0.1f}));
    static_cast<void>(createShape(world, d, circle(0.3f)));
    step(world, kTick);
    destroyBody(world, addBody(world, BodyKind::Dynamic, {}));
    return world;
}

struct Change {
    std::string name;
    std::function<void(World&)> make;
};

template <class Owner, class Member>
Change change(std::string name, std::vector<Owner>& (*list)(World&), Member Owner::*member) {
    return {std::move(name), [list, member](World& world) {
                auto* bytes = reinterpret_cast<unsigned char*>(&(list(world).back().*member));
                bytes[sizeof(Member) - 1] ^= 1u;
            }};
}

#define PLUMB_LIST(expression)    \
    +[](World & world) -> auto& { \
        return world.expression;  \
    }
#define PLUMB_CHANGE(type, list, member) change(#type "::" #member, PLUMB_LIST(list), &type::member)
#define PLUMB_SET(member)                                                                    \
    Change {                                                                                 \
#member, [](World & world) { reinterpret_cast<unsigned char&>(world.member) ^= 1u; } \
    }

std::vector<Change> everyField() {
    return {
        PLUMB_CHANGE(BodyPose, bodies.pose, centre),
        PLUMB_CHANGE(BodyPose, bodies.pose, rotation),
        PLUMB_CHANGE(BodyPose, bodies.pose, localCentre),
        PLUMB_CHANGE(BodyMotion, bodies.motion, velocity),
        PLUMB_CHANGE(BodyMotion, bodies.motion, angularVelocity),
        PLUMB_CHANGE(BodyMotion, bodies.motion, restTime),
        PLUMB_CHANGE(BodyMass, bodies.mass, inverseMass),
        PLUMB_CHANGE(BodyMass, bodies.mass, inverseInertia),
        PLUMB_CHANGE(BodyMass, bodies.mass, mass),
        PLUMB_CHANGE(BodyMass, bodies.mass, inertia),
        PLUMB_CHANGE(BodyDrive, bodies.drives.rows, force),
        PLUMB_CHANGE(BodyDrive, bodies.drives.rows, acceleration),
        PLUMB_CHANGE(BodyDrive, bodies.drives.rows, torque),
        PLUMB_CHANGE(BodyDrive, bodies.drives.rows, gravityScale),
        PLUMB_CHANGE(BodyDrive, bodies.drives.rows, linearDrag),
        PLUMB_CHANGE(BodyDrive, bodies.drives.rows, angularDrag),
        PLUMB_CHANGE(BodyInfo, bodies.info, generation),
        PLUMB_CHANGE(BodyInfo, bodies.info, kind),
        PLUMB_CHANGE(BodyInfo, bodies.info, flags),
        PLUMB_CHANGE(BodyInfo, bodies.info, quality),
        PLUMB_CHANGE(BodyInfo, bodies.info, firstShape),
        PLUMB_CHANGE(BodyInfo, bodies.info, firstJoint),
        PLUMB_CHANGE(BodyInfo, bodies.info, awakeIndex),
        PLUMB_CHANGE(BodyInfo, bodies.info, island),
        PLUMB_CHANGE(BodyInfo, bodies.info, sleepSpeed),
        PLUMB_CHANGE(BodyInfo, bodies.info, owned),
        PLUMB_CHANGE(BodyInfo, bodies.info, drive),
        PLUMB_CHANGE(BodyInfo, bodies.info, reach),
        PLUMB_CHANGE(BodyInfo, bodies.info, core),
        PLUMB_CHANGE(BodyInfo, bodies.info, user),
        PLUMB_CHANGE(SubstepController, bodies.substepControllers, quality),
        PLUMB_CHANGE(SubstepController, bodies.substepControllers, before),
        PLUMB_CHANGE(SubstepController, bodies.substepControllers, phase),
        PLUMB_CHANGE(SubstepController, bodies.substepControllers, patience),
        PLUMB_CHANGE(SubstepController, bodies.substepControllers, wait),
        PLUMB_CHANGE(SubstepController, bodies.substepControllers, error),
        PLUMB_CHANGE(SubstepController, bodies.substepControllers, first),
        PLUMB_CHANGE(EnergyShare, bodies.energies, credit),
        PLUMB_CHANGE(EnergyShare, bodies.energies, peak),
        PLUMB_CHANGE(Geometry, shapes.geometry, kind),
        PLUMB_CHANGE(Geometry, shapes.geometry, count),
        PLUMB_CHANGE(Geometry, shapes.geometry, first),
        PLUMB_CHANGE(Geometry, shapes.geometry, radius),
        PLUMB_CHANGE(Geometry, shapes.geometry, a),
        PLUMB_CHANGE(Geometry, shapes.geometry, b),
        PLUMB_CHANGE(Geometry, shapes.geometry, rotation),
        PLUMB_CHANGE(Geometry, shapes.geometry, after),
        PLUMB_CHANGE(AABB, shapes.bounds, min),
        PLUMB_CHANGE(AABB, shapes.bounds, max),
        PLUMB_CHANGE(Filter, shapes.filter, layers),
        PLUMB_CHANGE(Filter, shapes.filter, mask),
        PLUMB_CHANGE(Filter, shapes.filter, group),
        PLUMB_CHANGE(Filter, shapes.filter, body),
        PLUMB_SET(shapes.motion.back()),
        PLUMB_CHANGE(ShapeInfo, shapes.info, generation),
        PLUMB_CHANGE(ShapeInfo, shapes.info, body),
        PLUMB_CHANGE(ShapeInfo, shapes.info, next),
        PLUMB_CHANGE(ShapeInfo, shapes.info, flags),
        PLUMB_CHANGE(ShapeInfo, shapes.info, density),
        PLUMB_CHANGE(ShapeInfo, shapes.info, friction),
        PLUMB_CHANGE(ShapeInfo, shapes.info, bounciness),
        PLUMB_CHANGE(ShapeExtras, shapes.extras.rows, rollingResistance),
        PLUMB_CHANGE(ShapeExtras, shapes.extras.rows, surfaceSpeed),
        PLUMB_CHANGE(ShapeInfo, shapes.info, margin),
        PLUMB_CHANGE(ShapeExtras, shapes.extras.rows, oneWayDirection),
        PLUMB_CHANGE(ShapeExtras, shapes.extras.rows, frontLayers),
        PLUMB_CHANGE(ShapeExtras, shapes.extras.rows, frontMask),
        PLUMB_CHANGE(ShapeInfo, shapes.info, surface),
        PLUMB_CHANGE(ShapeInfo, shapes.info, extras),
        PLUMB_CHANGE(ShapeInfo, shapes.info, user),
        PLUMB_CHANGE(Corner, shapes.corners, point),
        PLUMB_CHANGE(Corner, shapes.corners, normal),
        PLUMB_CHANGE(Contact, contacts, shapeA),
        PLUMB_CHANGE(Contact, contacts, shapeB),
        PLUMB_CHANGE(Contact, contacts, bodyA),
        PLUMB_CHANGE(Contact, contacts, bodyB),
        PLUMB_CHANGE(Contact, contacts, flags),
        PLUMB_CHANGE(Contact, contacts, colour),
        PLUMB_CHANGE(Contact, contacts, count),
        PLUMB_CHANGE(Contact, contacts, bounciness),
        PLUMB_CHANGE(Contact, contacts, rollingResistance),
        PLUMB_CHANGE(Contact, contacts, surfaceSpeed),
        PLUMB_CHANGE(Contact, contacts, normal),
        PLUMB_CHANGE(Contact, contacts, friction),
        PLUMB_CHANGE(Contact, contacts, frictionImpulse),
        PLUMB_CHANGE(Contact, contacts, relativeRotation),
        PLUMB_CHANGE(Contact, contacts, rollingImpulse),
        PLUMB_CHANGE(Contact, contacts, ids),
        PLUMB_CHANGE(Contact, contacts, anchors),
        PLUMB_CHANGE(Contact, contacts, separation0),
        PLUMB_CHANGE(Contact, contacts, impulse0),
        PLUMB_CHANGE(Contact, contacts, separation1),
        PLUMB_CHANGE(Contact, contacts, impulse1),
        PLUMB_CHANGE(Contact, contacts, roundA),
        PLUMB_CHANGE(Contact, contacts, roundB),
        PLUMB_CHANGE(Contact, contacts, normalInA),
        PLUMB_CHANGE(Contact, sleepers.contacts, impulse0),
        PLUMB_CHANGE(Joint, joints.hot, bodyA),
        PLUMB_CHANGE(Joint, joints.hot, bodyB),
        PLUMB_CHANGE(Joint, joints.hot, anchorA),
        PLUMB_CHANGE(Joint, joints.hot, anchorB),
        PLUMB_CHANGE(Joint, joints.hot, kind),
        PLUMB_CHANGE(Joint, joints.hot, flags),
        PLUMB_CHANGE(Joint, joints.hot, colour),
        PLUMB_CHANGE(Joint, joints.hot, generation),
        PLUMB_CHANGE(Joint, joints.hot, force),
        PLUMB_CHANGE(Joint, joints.hot, torque),
        PLUMB_CHANGE(Joint, joints.hot, nextA),
        PLUMB_CHANGE(Joint, joints.hot, nextB),
        PLUMB_CHANGE(Joint, joints.hot, awakeIndex),
        PLUMB_SET(joints.definition.back().kind),
        PLUMB_SET(joints.definition.back().anchorA),
        PLUMB_SET(joints.definition.back().anchorB),
        PLUMB_SET(joints.definition.back().axis.y),
        PLUMB_SET(joints.definition.back().referenceAngle),
        PLUMB_SET(joints.definition.back().length),
        PLUMB_SET(joints.definition.back().ratio),
        PLUMB_SET(joints.definition.back().groundA),
        PLUMB_SET(joints.definition.back().groundB),
        PLUMB_SET(joints.definition.back().target.x),
        PLUMB_SET(joints.definition.back().target.y),
        PLUMB_SET(joints.definition.back().offset),
        PLUMB_SET(joints.definition.back().velocity),
        PLUMB_SET(joints.definition.back().jointA),
        PLUMB_SET(joints.definition.back().jointB),
        PLUMB_SET(joints.definition.back().limit.on),
        PLUMB_SET(joints.definition.back().limit.lower),
        PLUMB_SET(joints.definition.back().limit.upper),
        PLUMB_SET(joints.definition.back().motor.on),
        PLUMB_SET(joints.definition.back().motor.speed),
        PLUMB_SET(joints.definition.back().motor.maxForce),
        PLUMB_SET(joints.definition.back().spring.on),
        PLUMB_SET(joints.definition.back().spring.hertz),
        PLUMB_SET(joints.definition.back().spring.dampingRatio),
        PLUMB_SET(joints.definition.back().spring.rest),
        PLUMB_SET(joints.definition.back().maxForce),
        PLUMB_SET(joints.definition.back().maxTorque),
        PLUMB_SET(joints.definition.back().breakForce),
        PLUMB_SET(joints.definition.back().breakTorque),
        PLUMB_SET(joints.definition.back().reportForce),
        PLUMB_SET(joints.definition.back().reportTorque),
        PLUMB_SET(joints.definition.back().hertz),
        PLUMB_SET(joints.definition.back().dampingRatio),
        PLUMB_SET(joints.definition.back().collideConnected),
        PLUMB_SET(joints.definition.back().quality),
        PLUMB_SET(joints.definition.back().user),
        PLUMB_SET(settings.gravity.x),
        PLUMB_SET(settings.gravity.y),
        PLUMB_SET(settings.integrator),
        PLUMB_SET(settings.broadPhase),
        PLUMB_SET(settings.quality),
        PLUMB_SET(settings.iterations),
        PLUMB_SET(settings.automaticQuality),
        PLUMB_SET(settings.tolerance),
        PLUMB_SET(settings.directJoints),
        PLUMB_SET(settings.contactStiffness),
        PLUMB_SET(settings.jointStiffness),
        PLUMB_SET(settings.contactDampingRatio),
        PLUMB_SET(settings.jointDampingRatio),
        PLUMB_SET(settings.pushSpeed),
        PLUMB_SET(settings.deepPushRate),
        PLUMB_SET(settings.slop),
        PLUMB_SET(settings.recycleDistance),
        PLUMB_SET(settings.speculativeDistance),
        PLUMB_SET(settings.speculativeDistance),
        PLUMB_SET(settings.boundsMargin),
        PLUMB_SET(settings.bounceSpeed),
        PLUMB_SET(settings.sleepTime),
        PLUMB_SET(settings.maxSpeed),
        PLUMB_SET(settings.continuous),
        PLUMB_SET(settings.sleeping),
        PLUMB_SET(settings.stayEvents),
        PLUMB_SET(manifest.requesters[0]),
        PLUMB_SET(manifest.pinnedOn),
        PLUMB_SET(manifest.pinnedOff),
        PLUMB_SET(awake.back()),
        PLUMB_SET(bodies.dying.back()),
        PLUMB_SET(joints.awake.back()),
        PLUMB_SET(sleepers.islands.front()),
        PLUMB_SET(sleepers.nextContact.front()),
        PLUMB_SET(sleepers.nextBody.front()),
        PLUMB_SET(sleepers.islandOf.front()),
        PLUMB_SET(qualityCallers),
        PLUMB_SET(newJoints),
        PLUMB_SET(filtersStale),
        PLUMB_SET(islandsStale),
        PLUMB_SET(steps),
        Change{"moved", [](World& world) { world.moved.push_back(0); }},
        Change{"altered", [](World& world) { world.altered.push_back(0); }},
        Change{"bodies.free", [](World& world) { world.bodies.free.push_back(0); }},
        Change{"shapes.free", [](World& world) { world.shapes.free.push_back(0); }},
        Change{"bodies.drives.free", [](World& world) { world.bodies.drives.free.push_back(0); }},
        Change{"shapes.extras.free", [](World& world) { world.shapes.extras.free.push_back(0); }},
        Change{"shapes.dying", [](World& world) { world.shapes.dying.push_back(0); }},
        Change{"shapes.freeCorners", [](World& world) { world.shapes.freeCorners[2].push_back(0); }},
        Change{"joints.free", [](World& world) { world.joints.free.push_back(0); }},
        Change{"sleepers.freeIslands", [](World& world) { world.sleepers.freeIslands.push_back(0); }},
        Change{"sleepers.freeContacts", [](World& world) { world.sleepers.freeContacts.push_back(0); }},
    };
}

}  // namespace

TEST(Hash, dependsOnEveryField) {
    const World world = makeRich();
    ASSERT_FALSE(world.contacts.empty());
    ASSERT_FALSE(world.sleepers.contacts.empty());
    ASSERT_FALSE(world.joints.hot.empty());
    const std::uint64_t before = hashOf(world);
    for (const Change& change : everyField()) {
        World other = world;
        ASSERT_EQ(hashOf(other), before);
        change.make(other);
        EXPECT_NE(hashOf(other), before) << change.name;
    }
}

TEST(Hash, ignoresEventsAndTheWorkspace) {
    World world = makePit(20, 2);
    for (int i = 0; i < 60; ++i) step(world, kTick);
    World other = world;
    other.events.clear();
    EXPECT_EQ(hashOf(other), hashOf(world));
    Hasher a, b;
    addTo(a, world), addTo(b, other);
    EXPECT_EQ(a.value(), b.value());
}

TEST(Snapshot, aCopyContinuesLikeTheOriginal) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        SCOPED_TRACE(seed);
        World world = makePit(60, seed);
        for (int i = 0; i < 50; ++i) step(world, kTick);
        World copy = world;
        ASSERT_GT(world.contacts.size(), 20u);
        for (int i = 0; i < 60; ++i) {
            step(world, kTick);
            step(copy, kTick);
            ASSERT_EQ(hashOf(world), hashOf(copy)) << "step " << i;
        }
    }
}

TEST(Snapshot, restoringEverySeventhTickChangesNothing) {
    std::size_t asleepInAll = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        World straight = makePit(50, 100 + seed);
        straight.settings.sleepTime = 0.25f;
        World broken = straight, snapshot = straight;
        std::size_t mostAsleep = 0, wakes = 0, asleep = 0, touching = 0;
        for (int i = 0; i < 700; ++i) {
            if (i % 7 == 0) {
                snapshot = broken;
                for (int ahead = 0; ahead < 5; ++ahead) {
                    disturb(broken, i + ahead);
                    step(broken, kTick);
                }
                broken = snapshot;
            }
            disturb(straight, i);
            disturb(broken, i);
            step(straight, kTick);
            step(broken, kTick);
            ASSERT_EQ(hashOf(straight), hashOf(broken)) << "step " << i;
            touching = std::max(touching, straight.contacts.size());
            const std::size_t now = bodyCount(straight) - straight.awake.size();
            wakes += now < asleep ? 1 : 0;
            asleep = now;
            mostAsleep = std::max(mostAsleep, asleep);
        }
        EXPECT_GT(touching, 30u);
        EXPECT_GT(wakes, 0u);
        asleepInAll += mostAsleep;
    }
    EXPECT_GT(asleepInAll, 80u);
}
