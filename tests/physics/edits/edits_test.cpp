#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "physics/queries/lists.hpp"
#include "physics/queries/ray_cast.hpp"
#include "tests/physics/support/edited_worlds.hpp"

// After an edit at run time the world behaves as if it had been created that way.

namespace plumb::physics {
namespace {

TEST(Edits, changedShapesBehaveAsIfCreatedThatWay) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::vector<ShapeDefinition> before, after;
        std::vector<Geometry> geometryBefore, geometryAfter;
        for (int i = 0; i < 30; ++i) {
            before.push_back(randomDefinition(random));
            after.push_back(randomDefinition(random));
            geometryBefore.push_back(randomGeometry(random, seed % 2 == 0));
            geometryAfter.push_back(randomGeometry(random, seed % 2 == 0));
        }
        const auto at = [](auto& list) { return [&](int i) { return list[static_cast<std::size_t>(i)]; }; };
        World changed = heap(30, dynamic, at(before), at(geometryBefore));
        World created = heap(30, dynamic, at(after), at(geometryAfter));
        for (std::uint32_t i = 0; i < 30; ++i) {
            const ShapeId shape = shapeAt(changed, i + 1);
            ASSERT_TRUE(setGeometry(changed, shape, geometryAfter[i]).ok());
            ASSERT_TRUE(setDefinition(changed, shape, after[i]).ok());
            ShapeDefinition wanted = after[i];
            if (wanted.oneWay) wanted.oneWayDirection = normalized(wanted.oneWayDirection);
            EXPECT_EQ(definitionOf(changed, shape), wanted);
        }
        const int steps = seed % 2 == 0 ? 60 : 1;
        run(changed, steps);
        run(created, steps);
        expectNear(changed, created);
        EXPECT_TRUE(seed % 2 != 0 || sameBytes(changed.bodies.motion, created.bodies.motion));
    }
}

TEST(Edits, bodiesOfChangedKindBehaveAsIfCreatedThatWay) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::vector<BodyKind> before, after;
        for (int i = 0; i < 30; ++i) {
            before.push_back(static_cast<BodyKind>(1 + random.below(3)));
            after.push_back(random.below(3) != 0 ? BodyKind::Dynamic
                                                 : static_cast<BodyKind>(1 + random.below(2)));
        }
        const auto at = [](auto& list) { return [&](int i) { return list[static_cast<std::size_t>(i)]; }; };
        Random outlines = Random::seeded(seed);
        std::vector<Geometry> geometry;
        for (int i = 0; i < 30; ++i) geometry.push_back(randomGeometry(outlines, true));
        const auto usual = [](int) { return ShapeDefinition{}; };
        World changed = heap(30, at(before), usual, at(geometry)),
              created = heap(30, at(after), usual, at(geometry));
        for (std::uint32_t i = 0; i < 30; ++i) {
            const BodyId body = bodyAt(changed, i + 1);
            ASSERT_TRUE(setKind(changed, body, after[i]).ok());
        }
        // The order of World::awake differs between the worlds, so sums over islands, and energy corrections
        // computed from these sums, are rounded differently.
        run(changed, 25);
        run(created, 25);
        expectNear(changed, created, 1.0e-4);
    }
}

TEST(Edits, disablingAndEnablingABodyChangesNothing) {
    World touched = makePit(40, 3), plain = makePit(40, 3);
    for (std::uint32_t i = 0; i < 41; ++i) setEnabled(touched, bodyAt(touched, i), false);
    EXPECT_TRUE(touched.awake.empty());
    EXPECT_FALSE(castRay(touched, {0.0, 50.0}, {0.0f, -100.0f}).has_value());
    for (std::uint32_t i = 0; i < 41; ++i) setEnabled(touched, bodyAt(touched, i), true);
    run(touched, 120);
    run(plain, 120);
    expectSame(touched, plain);
}

TEST(Edits, aDisabledBodyHasNoInfluence) {
    for (std::uint32_t gone = 5; gone < 40; gone += 7) {
        World disabled = makePit(40, 4), without = makePit(40, 4);
        setEnabled(disabled, bodyAt(disabled, gone), false);
        destroyBody(without, bodyAt(without, gone));
        const BodyPose kept = disabled.bodies.pose[gone];
        run(disabled, 120);
        run(without, 120);
        EXPECT_EQ(disabled.bodies.pose[gone], kept);
        for (std::size_t i = 0; i < 41; ++i) {
            if (i == gone) continue;
            EXPECT_EQ(disabled.bodies.pose[i], without.bodies.pose[i]) << i;
        }
    }
}

TEST(Edits, aCopyOfAnEditedWorldContinuesWithTheSameBits) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        World world = makePit(25, seed);
        world.settings.sleepTime = 0.1f;
        Random random = Random::seeded(seed);
        for (int round = 0; round < 12; ++round) {
            run(world, static_cast<int>(random.below(25)));
            World copy = world;  // a copy has no workspace
            Random same = random;
            const std::uint32_t edits = 1 + random.below(4);
            static_cast<void>(same.below(4));
            for (std::uint32_t i = 0; i < edits; ++i) {
                applyRandomEdit(world, random);
                applyRandomEdit(copy, same);
            }
            ASSERT_EQ(hashOf(world), hashOf(copy));
            for (int i = 0; i < 5; ++i) {
                step(world, kTick);
                step(copy, kTick);
                ASSERT_EQ(hashOf(world), hashOf(copy)) << round << " " << i;
                ASSERT_EQ(world.events.size(), copy.events.size());
            }
            for (const BodyPose& pose : world.bodies.pose) ASSERT_TRUE(std::isfinite(pose.centre.y));
        }
    }
}

TEST(Edits, theEffectsInUseAreConsistentAfterEdits) {
    // If everything is destroyed after random edits, no effect must be in use any more.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        World world = makePit(15, seed);
        Random random = Random::seeded(seed);
        for (int i = 0; i < 60; ++i) {
            applyRandomEdit(world, random);
            if (i % 6 == 0) step(world, kTick);
        }
        for (std::uint32_t i = 0; i < world.bodies.size(); ++i) destroyBody(world, bodyAt(world, i));
        EXPECT_EQ(world.manifest.requesters, Manifest{}.requesters) << seed;
        EXPECT_EQ(world.qualityCallers, 0u);
        run(world, 2);
        EXPECT_TRUE(world.contacts.empty());
        EXPECT_EQ(bodyCount(world), 0u);
    }
}

TEST(Edits, sleepingBodiesWakeUpIfTheirGroundChanges) {
    const std::function<void(Shelf&)> changes[] = {
        [](Shelf& s) { setEnabled(s.world, s.shelf, false); },
        [](Shelf& s) { EXPECT_TRUE(setKind(s.world, s.shelf, BodyKind::Dynamic).ok()); },
        [](Shelf& s) {
            EXPECT_TRUE(setGeometry(s.world, s.board, box({0.1f, 0.1f}, {-0.5f, 0.0f})).ok());
        },
        [](Shelf& s) {
            const Vec2 points[] = {{-1.0f, 0.0f}, {0.0f, 0.0f}, {-0.5f, 0.1f}};
            EXPECT_TRUE(setPolygon(s.world, s.board, points).ok());
        },
        [](Shelf& s) { EXPECT_TRUE(change(s.world, s.board, [](auto& d) { d.isTrigger = true; }).ok()); },
        [](Shelf& s) { EXPECT_TRUE(change(s.world, s.board, [](auto& d) { d.mask = 0; }).ok()); },
    };
    for (const auto& make : changes) {
        Shelf s;
        make(s);
        run(s.world, 1);
        EXPECT_TRUE(isAwake(s.world, s.crate));
        run(s.world, 60);
        EXPECT_LT(positionOf(s.world, s.crate).y, -2.0) << &make - changes;
    }
    Shelf kept;
    setAwake(kept.world, kept.crate, true);
    EXPECT_TRUE(change(kept.world, kept.board, [](auto& d) { d.density = 7.0f; }).ok());
    EXPECT_TRUE(setKind(kept.world, kept.shelf, BodyKind::Kinematic).ok());
    run(kept.world, 120);
    EXPECT_NEAR(positionOf(kept.world, kept.crate).y, 0.6, 0.01);
}

TEST(Edits, endedAndBeganEventsMatchTheTouchingPairsAfterAChange) {
    Shelf s;
    EXPECT_TRUE(setGeometry(s.world, s.board, box({1.2f, 0.1f})).ok());
    run(s.world, 1);
    ASSERT_EQ(s.world.events.size(), 2u);
    EXPECT_EQ(s.world.events[0].phase, ContactPhase::Ended);
    EXPECT_EQ(s.world.events[1].phase, ContactPhase::Began);
    setEnabled(s.world, s.shelf, false);
    run(s.world, 1);
    ASSERT_EQ(s.world.events.size(), 1u);
    EXPECT_EQ(s.world.events[0].phase, ContactPhase::Ended);
}

TEST(Edits, enablingATriggerReportsTheBodiesInside) {
    Shelf s;
    EXPECT_TRUE(change(s.world, s.board, [](auto& d) { d.isTrigger = true; }).ok());
    run(s.world, 1);
    std::vector<ShapeId> inside;
    overlapsOf(s.world, s.board, inside);
    EXPECT_EQ(inside.size(), 1u);
    std::vector<const Contact*> touching;
    contactsOf(s.world, s.board, touching);
    EXPECT_TRUE(touching.empty());
}

TEST(Edits, callbacksCannotChangeTheWorld) {
    struct Owner {
        World* world = nullptr;
        int calls = 0, refusals = 0;
    } owner;
    World world = makePit(20, 2), plain = makePit(20, 2);
    for (World* each : {&world, &plain}) {
        static_cast<void>(createJoint(*each, {.a = bodyAt(*each, 3), .b = bodyAt(*each, 4)}));
    }
    owner.world = &world;
    StepOptions options;
    options.hooks.context = &owner;
    options.hooks.preSolve = [](void* context, const World&, const Contact& contact) {
        Owner& self = *static_cast<Owner*>(context);
        World& own = *self.world;
        const BodyId body = bodyAt(own, contact.bodyB);
        const ShapeId shape = shapeAt(own, contact.shapeB);
        const JointId joint{0, own.joints.hot[0].generation};
        ++self.calls;
        const bool done[] = {setKind(own, body, BodyKind::Static).ok(),
                             setGeometry(own, shape, circle(1.0f)).ok(),
                             setDefinition(own, shape, {.density = 5.0f}).ok(),
                             setMassData(own, body, {5.0f, {}, 1.0f}).ok(),
                             setVelocity(own, body, {1.0f, 0.0f}).ok(),
                             applyAngularImpulse(own, body, 1.0f).ok(),
                             setSleepSpeed(own, body, 1.0f).ok(),
                             createBody(own, {}).ok(),
                             createShape(own, body, circle(1.0f)).ok(),
                             createJoint(own, {.a = body, .b = bodyAt(own, 0)}).ok(),
                             change(own, joint, [](auto& d) { d.motor.on = true; }).ok()};
        for (const bool ok : done) self.refusals += ok ? 0 : 1;
        setEnabled(own, body, false);
        clearForces(own, body);
        destroyShape(own, shape);
        destroyBody(own, body);
        destroyJoint(own, joint);
        setAwake(own, body, false);
        setUser(own, body, 99);
        setFilter(own, shape, 0, 0, 0);
        step(own, kTick);
        return true;
    };
    for (int i = 0; i < 40; ++i) {
        step(world, kTick, options);
        step(plain, kTick);
    }
    EXPECT_GT(owner.calls, 100);
    EXPECT_EQ(owner.refusals, 11 * owner.calls);
    EXPECT_EQ(hashOf(world), hashOf(plain));
}

TEST(Edits, settingTheMassDataOfTheShapesChangesNothing) {
    World set = makePit(20, 5), plain = makePit(20, 5);
    for (std::uint32_t i = 1; i <= 20; ++i) {
        const BodyId body = bodyAt(set, i);
        ASSERT_TRUE(setMassData(set, body, massDataOf(set, body)).ok());
    }
    run(set, 60);
    run(plain, 60);
    EXPECT_TRUE(sameBytes(set.bodies.pose, plain.bodies.pose));
    for (std::uint32_t i = 1; i <= 20; ++i) {
        const BodyId body = bodyAt(set, i);
        ASSERT_TRUE(setMassData(set, body, {3.0f, {0.1f, 0.0f}, 0.7f}).ok());
        const WorldPosition place = positionOf(set, body);
        ASSERT_TRUE(setMassData(set, body, {}).ok());
        EXPECT_EQ(massDataOf(set, body).mass, massDataOf(plain, body).mass);
        EXPECT_NEAR(positionOf(set, body).x, place.x, 1.0e-6);
    }
}

TEST(Edits, aStackStaysAtRestIfAShapeMovesACenterOfMass) {
    // The light shape moves the crate's center of mass by up to 0.1 m and adds little weight.
    for (const Vec2 place : {Vec2{0.3f, 0.0f}, Vec2{-0.2f, 0.2f}, Vec2{0.0f, -0.3f}}) {
        for (const bool removes : {false, true}) {
            for (int changed = 0; changed < 3; ++changed) {
                Playground scene;
                scene.floor();
                std::vector<BodyId> crates;
                for (int i = 0; i < 3; ++i) {
                    crates.push_back(scene.crate({0.0, 0.5 + i}));
                    if (removes && i == changed)
                        scene.shape(crates.back(), box({0.1f, 0.1f}, place), {.density = 10.0f});
                }
                const auto at = static_cast<std::size_t>(changed);
                scene.run(240);
                std::vector<WorldPosition> before;
                for (const BodyId crate : crates) before.push_back(positionOf(scene.world, crate));
                if (removes) {
                    std::vector<ShapeId> shapes;
                    shapesOf(scene.world, crates[at], shapes);
                    destroyShape(scene.world, shapes.back());
                } else {
                    scene.shape(crates[at], box({0.1f, 0.1f}, place), {.density = 10.0f});
                }
                for (int i = 0; i < 30; ++i) {
                    scene.run(1);
                    EXPECT_TRUE(scene.world.events.empty());
                    for (std::size_t c = 0; c < crates.size(); ++c) {
                        EXPECT_NEAR(positionOf(scene.world, crates[c]).x, before[c].x, 5.0e-4) << i;
                        EXPECT_NEAR(positionOf(scene.world, crates[c]).y, before[c].y, 5.0e-4) << i;
                        EXPECT_LT(length(scene.velocity(crates[c])), 0.02f) << i;
                    }
                }
            }
        }
    }
}

TEST(Edits, torqueUsesTheInertiaThatWasSet) {
    World world;
    world.settings.gravity = {};
    const BodyId body = addBody(world, BodyKind::Dynamic, {});
    ASSERT_TRUE(createShape(world, body, box({0.5f, 0.5f})).ok());
    ASSERT_TRUE(setMassData(world, body, {2.0f, {0.25f, 0.0f}, 0.5f}).ok());
    ASSERT_TRUE(applyAngularImpulse(world, body, 1.5f).ok());
    EXPECT_FLOAT_EQ(angularVelocityOf(world, body), 3.0f);
    EXPECT_EQ(centreOf(world, body), (WorldPosition{0.25, 0.0}));
    const Vec2 speed = velocityAt(world, body, positionOf(world, body));
    EXPECT_NEAR(speed.y, -0.75f, 1.0e-6f);
    ASSERT_TRUE(applyForce(world, body, {7.0f, 0.0f}).ok());
    ASSERT_TRUE(applyTorque(world, body, 7.0f).ok());
    clearForces(world, body);
    step(world, kTick);
    EXPECT_EQ(velocityOf(world, body), Vec2{});
    EXPECT_FLOAT_EQ(angularVelocityOf(world, body), 3.0f);
}

}  // namespace
}  // namespace plumb::physics
