#include <gtest/gtest.h>

#include "physics/effects/field_types.hpp"
#include "physics/model/fields.hpp"
#include "physics/queries/lists.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

// Getters called with stale ids return defaults and change nothing.

namespace plumb::physics {
namespace {

template <class Thing>
std::vector<Id<Thing>> gone(Id<Thing> destroyed) {
    return {destroyed, {}, {0, 77}, {9999, 1}, {kNone, 1}, {kNone - 1, kNone}};
}

TEST(StaleIds, destroyedBodiesReadAsAtRestAtTheOrigin) {
    World world = makePit(6, 1);
    const BodyId destroyed{3, world.bodies.info[3].generation};
    destroyBody(world, destroyed);
    for (int steps = 0; steps < 2; ++steps) {
        const std::uint64_t before = hashOf(world);
        for (const BodyId id : gone(destroyed)) {
            EXPECT_FALSE(alive(world, id) || isAwake(world, id) || isEnabled(world, id));
            EXPECT_EQ(positionOf(world, id), WorldPosition{});
            EXPECT_EQ(centreOf(world, id), WorldPosition{});
            EXPECT_EQ(worldPoint(world, id, {1.0f, 2.0f}), (WorldPosition{1.0, 2.0}));
            EXPECT_EQ(localPoint(world, id, {1.0, 2.0}), (Vec2{1.0f, 2.0f}));
            EXPECT_EQ(rotationOf(world, id), Rot{});
            EXPECT_EQ(velocityOf(world, id), Vec2{});
            EXPECT_EQ(velocityAt(world, id, {3.0, 3.0}), Vec2{});
            EXPECT_EQ(angularVelocityOf(world, id), 0.0f);
            EXPECT_EQ(massOf(world, id), 0.0f);
            EXPECT_EQ(massDataOf(world, id).inertia, 0.0f);
            EXPECT_EQ(driveOf(world, id), BodyDrive{});
            EXPECT_EQ(predictTransform(world, id, 1.0f), Frame{});
            std::vector<ShapeId> shapes{{0, 1}};
            std::vector<JointId> joints{{0, 1}};
            std::vector<const Contact*> contacts{nullptr};
            shapesOf(world, id, shapes);
            jointsOf(world, id, joints);
            contactsOf(world, id, contacts);
            EXPECT_TRUE(shapes.empty() && joints.empty() && contacts.empty());
            EXPECT_EQ(boundsOf(world, id), AABB{});
        }
        EXPECT_EQ(hashOf(world), before);
        step(world, kTick);
    }
}

TEST(StaleIds, destroyedShapesReadAsWithoutBodyAndWithDefaults) {
    World world = makePit(6, 1);
    for (int i = 0; i < 60; ++i) step(world, kTick);
    const ShapeId destroyed{3, world.shapes.info[3].generation};
    destroyShape(world, destroyed);
    for (int steps = 0; steps < 2; ++steps) {
        for (const ShapeId id : gone(destroyed)) {
            EXPECT_EQ(bodyOf(world, id), BodyId{});
            EXPECT_EQ(definitionOf(world, id), ShapeDefinition{});
            std::vector<ShapeId> found{{0, 1}};
            std::vector<const Contact*> contacts{nullptr};
            segmentsOf(world, id, found);
            EXPECT_TRUE(found.empty());
            found.push_back({0, 1});
            overlapsOf(world, id, found);
            contactsOf(world, id, contacts);
            EXPECT_TRUE(found.empty() && contacts.empty());
            destroyChain(world, id);
        }
        step(world, kTick);
    }
}

TEST(StaleIds, destroyedJointsFieldsAndSoftBodiesReadAsDefaults) {
    World world = makePit(6, 1);
    const JointId joint = *createJoint(world, {.a = {1, 1}, .b = {2, 1}, .length = 7.0f});
    const FieldId field = *createField(world, {.strength = 3.0f});
    const SoftBodyId rope = *createRope(world, {0.0, 9.0}, {1.0, 9.0}, 5);
    for (int i = 0; i < 10; ++i) step(world, kTick);
    destroyJoint(world, joint);
    destroyField(world, field);
    destroySoftBody(world, rope);
    for (const JointId id : gone(joint)) {
        EXPECT_EQ(definitionOf(world, id).length, JointDefinition{}.length);
        EXPECT_EQ(readingOf(world, id).value, 0.0f);
        EXPECT_EQ(readingOf(world, id).separation, 0.0f);
        EXPECT_EQ(jointForce(world, id), Vec2{});
        EXPECT_EQ(jointTorque(world, id), 0.0f);
        EXPECT_FALSE(setMotorSpeed(world, id, 1.0f).ok());
        EXPECT_FALSE(setTarget(world, id, {}).ok());
    }
    for (const FieldId id : gone(field)) EXPECT_EQ(definitionOf(world, id).strength, 0.0f);
    for (const SoftBodyId id : gone(rope)) {
        EXPECT_TRUE(particlesOf(world, id).empty());
        EXPECT_TRUE(softBodyOf(world, id).links.empty());
        EXPECT_FALSE(pinParticle(world, id, 0, true).ok());
    }
}

TEST(StaleIds, anErrorNamesTheCoincidingPointsOfAChain) {
    World world;
    const BodyId ground = addBody(world, BodyKind::Static, {});
    for (const bool closed : {true, false}) {
        for (std::size_t at = closed ? 0 : 1; at < (closed ? 6u : 4u); ++at) {
            std::vector<Vec2> points{{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f},
                                     {2.0f, 1.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}};
            points[(at + 1) % 6] = points[at];
            const auto made = createChain(world, ground, points, closed);
            ASSERT_FALSE(made.ok());
            const std::string both = "points " + std::to_string(at) + " and " + std::to_string((at + 1) % 6);
            EXPECT_NE(made.error().text().find(both), std::string::npos) << made.error().text();
        }
    }
}

}  // namespace
}  // namespace plumb::physics
