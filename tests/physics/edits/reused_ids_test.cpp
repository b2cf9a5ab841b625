#include <gtest/gtest.h>

#include "physics/model/fields.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Ids of destroyed objects must stay invalid when their indices are reused.

using namespace plumb;
using namespace plumb::physics;

namespace {

struct Ids {
    BodyId body;
    ShapeId shape;
    JointId joint;
    FieldId field;
    SoftBodyId soft;
};

/// Adds one object of each kind.
Ids addAll(World& world, BodyId ground, double x) {
    Ids ids;
    ids.body = addBody(world, BodyKind::Dynamic, {x, 5.0});
    ids.shape = *createShape(world, ids.body, circle(0.4f));
    ids.joint = *createJoint(world, {.a = ground, .b = ids.body});
    ids.field = *createField(world, {.kind = FieldKind::Wind, .velocity = {1.0f, 0.0f}});
    ids.soft = *createRope(world, {x, 10.0}, {x + 1.0, 10.0}, 3);
    return ids;
}

void expectAll(const World& world, const Ids& ids, bool alive) {
    EXPECT_EQ(physics::alive(world, ids.body), alive);
    EXPECT_EQ(physics::alive(world, ids.shape), alive);
    EXPECT_EQ(physics::alive(world, ids.joint), alive);
    EXPECT_EQ(physics::alive(world, ids.field), alive);
    EXPECT_EQ(physics::alive(world, ids.soft), alive);
}

}  // namespace

TEST(ReusedIds, ofObjectsCreatedAfterASnapshotAreInvalidOnceItIsRestored) {
    for (int before = 0; before < 4; ++before) {
        SCOPED_TRACE(before);
        World world;
        const BodyId ground = addBody(world, BodyKind::Static, {});
        for (int i = 0; i < before; ++i) expectAll(world, addAll(world, ground, i), true);
        const World snapshot = world;
        std::vector<Ids> later;
        for (int i = 0; i < 3; ++i) later.push_back(addAll(world, ground, 10.0 + i));
        for (const Ids& ids : later) expectAll(world, ids, true);
        world = snapshot;  // the memory of the copy may still contain the later objects
        for (const Ids& ids : later) expectAll(world, ids, false);
        EXPECT_EQ(fieldCount(world), static_cast<std::size_t>(before));
        EXPECT_EQ(bodyCount(world), static_cast<std::size_t>(before) + 1);
        step(world, kTick);
        for (const Ids& ids : later) {
            destroyBody(world, ids.body);
            destroyShape(world, ids.shape);
            destroyJoint(world, ids.joint);
            destroyField(world, ids.field);
            destroySoftBody(world, ids.soft);
            EXPECT_FALSE(setVelocity(world, ids.body, {}).ok());
            EXPECT_EQ(jointForce(world, ids.joint), Vec2{});
            EXPECT_EQ(jointTorque(world, ids.joint), 0.0f);
        }
        EXPECT_EQ(bodyCount(world), static_cast<std::size_t>(before) + 1);
    }
}

TEST(ReusedIds, ofDestroyedObjectsDoNotReferToTheirSuccessors) {
    World world;
    const BodyId ground = addBody(world, BodyKind::Static, {});
    Ids ids = addAll(world, ground, 0.0);
    for (int i = 0; i < 4; ++i) {
        const Ids gone = ids;
        destroyJoint(world, ids.joint);
        destroyShape(world, ids.shape);
        destroyBody(world, ids.body);
        destroyField(world, ids.field);
        destroySoftBody(world, ids.soft);
        expectAll(world, gone, false);
        EXPECT_EQ(fieldCount(world), 0u);
        for (int tick = 0; tick < 2; ++tick) step(world, kTick);
        ids = addAll(world, ground, 1.0 + i);
        expectAll(world, gone, false);
        expectAll(world, ids, true);
        EXPECT_EQ(ids.field.index, gone.field.index) << "the freed index must be reused";
        EXPECT_EQ(ids.joint.index, gone.joint.index);
        EXPECT_EQ(ids.body.index, gone.body.index);
        EXPECT_EQ(ids.shape.index, gone.shape.index);
    }
    expectAll(world, {}, false);
    Ids never = ids;  // generation 0 is never assigned
    never.body.generation = never.shape.generation = never.joint.generation = never.field.generation =
        never.soft.generation = 0;
    expectAll(world, never, false);
}

// Regression: the contact of a destroyed body was updated once more and ended as a contact of a static body.
// The next body with the same index was then solved as touching, but not in a copy of the world.
TEST(ReusedIds, keepNoContactsOfDestroyedBodies) {
    for (const int gone : {0, 1}) {
        SCOPED_TRACE(gone);
        World world;
        const BodyId bodies[] = {addBody(world, BodyKind::Dynamic, {}),
                                 addBody(world, BodyKind::Dynamic, {1.0, 0.0})};
        ShapeId shapes[2];
        for (int i = 0; i < 2; ++i) shapes[i] = *createShape(world, bodies[i], box({0.5f, 0.5f}));
        for (int i = 0; i < 3; ++i) step(world, kTick);
        ASSERT_EQ(world.contacts.size(), 1u);
        destroyBody(world, bodies[gone]);
        EXPECT_TRUE(setFriction(world, shapes[1 - gone], 0.9f).ok());
        step(world, kTick);
        const BodyId next = *createBody(world, {.position = {50.0, 0.0}, .velocity = {-3.7f, 1.3f}});
        EXPECT_EQ(next.index, bodies[gone].index);
        static_cast<void>(createShape(world, next, circle(0.5f)));
        World copy = world;
        for (World* each : {&world, &copy}) {
            for (int i = 0; i < 60; ++i) step(*each, kTick);
        }
        EXPECT_EQ(positionOf(world, next), positionOf(copy, next));
        EXPECT_EQ(hashOf(world), hashOf(copy));
    }
}

TEST(Edits, kindChangesThatLeaveAJointWithoutAMovableBodyAreRejected) {
    constexpr BodyKind kKinds[] = {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic};
    for (const JointKind kind :
         {JointKind::Revolute, JointKind::Distance, JointKind::Mouse, JointKind::Motor}) {
        for (const BodyKind a : kKinds) {
            for (const BodyKind b : kKinds) {
                SCOPED_TRACE(testing::Message() << int(kind) << ": " << int(a) << ", " << int(b));
                const bool pulls = kind == JointKind::Mouse
                                       ? b == BodyKind::Dynamic
                                       : a == BodyKind::Dynamic || b == BodyKind::Dynamic;
                World world;
                const BodyId bodies[] = {addBody(world, BodyKind::Dynamic, {}),
                                         addBody(world, BodyKind::Dynamic, {2.0, 0.0})};
                for (const BodyId body : bodies) static_cast<void>(createShape(world, body, circle(0.5f)));
                World other = world;
                ASSERT_TRUE(createJoint(world, {.kind = kind, .a = bodies[0], .b = bodies[1]}).ok());
                const bool edited = setKind(world, bodies[0], a).ok() && setKind(world, bodies[1], b).ok();
                EXPECT_EQ(edited, pulls) << "as a change";
                ASSERT_TRUE(setKind(other, bodies[0], a).ok() && setKind(other, bodies[1], b).ok());
                EXPECT_EQ(createJoint(other, {.kind = kind, .a = bodies[0], .b = bodies[1]}).ok(), pulls);
                for (int i = 0; i < 3; ++i) step(world, kTick);
            }
        }
    }
}
