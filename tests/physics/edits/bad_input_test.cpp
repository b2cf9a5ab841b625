#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/physics/support/world_of_bodies.hpp"

using namespace plumb;
using namespace plumb::physics;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

bool isSound(const World& world) {
    const auto finite = [](const BodyPose& pose) {
        return std::isfinite(pose.centre.x) && std::isfinite(pose.centre.y) &&
               std::isfinite(pose.rotation.cos) && std::isfinite(pose.rotation.sin);
    };
    const auto calm = [](const BodyMotion& motion) {
        return isFinite(motion.velocity) && std::isfinite(motion.angularVelocity);
    };
    return std::all_of(world.bodies.pose.begin(), world.bodies.pose.end(), finite) &&
           std::all_of(world.bodies.motion.begin(), world.bodies.motion.end(), calm);
}

/// A world with one object of each kind, to which invalid input is passed.
struct Samples {
    World world = makePit(6, 1);
    BodyId body = {1, 1}, other = {2, 1};
    BodyId kinematic = addBody(world, BodyKind::Kinematic, {0.0, 20.0});
    ShapeId shape = {world.bodies.info[1].firstShape, 1};
    JointId joint = *createJoint(world, {.a = body, .b = other});

    Samples() {
        for (int i = 0; i < 30; ++i) step(world, kTick);
    }
};

/// Passes an invalid number as one parameter. @return the error; nothing if the number was accepted
using Attempt = std::function<std::optional<Error>(Samples&, double bad)>;

template <class T>
std::optional<Error> errorOf(const Result<T>& result) {
    if (result) return std::nullopt;
    return result.error();
}

template <class Definition, class Create>
Attempt creating(Definition fixed, std::function<void(Definition&, float)> spoil, Create create) {
    return [=](Samples& patient, double bad) {
        Definition definition = fixed;
        spoil(definition, static_cast<float>(bad));
        return errorOf(create(patient, definition));
    };
}

Attempt body(std::function<void(BodyDefinition&, float)> spoil) {
    return creating<BodyDefinition>({}, std::move(spoil), [](Samples& p, const BodyDefinition& definition) {
        return createBody(p.world, definition);
    });
}
Attempt shape(std::function<void(ShapeDefinition&, float)> spoil) {
    return creating<ShapeDefinition>({}, std::move(spoil), [](Samples& p, const ShapeDefinition& definition) {
        return createShape(p.world, p.body, circle(1.0f), definition);
    });
}
Attempt outline(const Geometry& good, std::function<void(Geometry&, float)> spoil) {
    return creating<Geometry>(good, std::move(spoil), [](Samples& p, const Geometry& geometry) {
        return createShape(p.world, p.body, geometry);
    });
}
Attempt joint(std::function<void(JointDefinition&, float)> spoil) {
    return [spoil = std::move(spoil)](Samples& p, double bad) {
        JointDefinition definition{.a = p.body, .b = p.other};
        spoil(definition, static_cast<float>(bad));
        return errorOf(createJoint(p.world, definition));
    };
}

#define PLUMB_SPOIL(maker, type, member)                                      \
    {                                                                         \
#type "::" #member, maker([](type& d, float bad) { d.member = bad; }) \
    }
#define PLUMB_OUTLINE(good, member)                                                      \
    {                                                                                    \
#good " " #member, outline(good, [](Geometry& g, float bad) { g.member = bad; }) \
    }
#define PLUMB_CALL(call)                                                                                                          \
    {                                                                                                                             \
#call, [](Samples& p, [[maybe_unused]] double d) { [[maybe_unused]] const auto f = static_cast<float>(d); return errorOf(call); } \
    }

struct Named {
    std::string name;
    Attempt attempt;
};

std::vector<Named> creators() {
    return {
        PLUMB_SPOIL(body, BodyDefinition, position.x),
        PLUMB_SPOIL(body, BodyDefinition, position.y),
        PLUMB_SPOIL(body, BodyDefinition, angle),
        PLUMB_SPOIL(body, BodyDefinition, velocity.x),
        PLUMB_SPOIL(body, BodyDefinition, velocity.y),
        PLUMB_SPOIL(body, BodyDefinition, angularVelocity),
        PLUMB_SPOIL(body, BodyDefinition, acceleration.x),
        PLUMB_SPOIL(body, BodyDefinition, acceleration.y),
        PLUMB_SPOIL(body, BodyDefinition, gravityScale),
        PLUMB_SPOIL(body, BodyDefinition, linearDrag),
        PLUMB_SPOIL(body, BodyDefinition, angularDrag),
        PLUMB_SPOIL(body, BodyDefinition, sleepSpeed),
        PLUMB_SPOIL(shape, ShapeDefinition, density),
        PLUMB_SPOIL(shape, ShapeDefinition, friction),
        PLUMB_SPOIL(shape, ShapeDefinition, bounciness),
        PLUMB_SPOIL(shape, ShapeDefinition, rollingResistance),
        PLUMB_SPOIL(shape, ShapeDefinition, surfaceSpeed),
        PLUMB_SPOIL(shape, ShapeDefinition, oneWayDirection.x),
        PLUMB_SPOIL(shape, ShapeDefinition, oneWayDirection.y),
        PLUMB_OUTLINE(circle(1.0f), radius),
        PLUMB_OUTLINE(circle(1.0f), a.x),
        PLUMB_OUTLINE(circle(1.0f), a.y),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), b.x),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), b.y),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), radius),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), rotation.cos),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), rotation.sin),
        PLUMB_OUTLINE(capsule({}, {1.0f, 0.0f}, 1.0f), radius),
        PLUMB_OUTLINE(capsule({}, {1.0f, 0.0f}, 1.0f), a.x),
        PLUMB_OUTLINE(capsule({}, {1.0f, 0.0f}, 1.0f), b.y),
        PLUMB_OUTLINE(segment({}, {1.0f, 0.0f}), a.y),
        PLUMB_OUTLINE(segment({}, {1.0f, 0.0f}), b.x),
        PLUMB_OUTLINE(segment({}, {1.0f, 0.0f}), radius),
        PLUMB_SPOIL(joint, JointDefinition, anchorA.x),
        PLUMB_SPOIL(joint, JointDefinition, anchorB.y),
        PLUMB_SPOIL(joint, JointDefinition, axis.x),
        PLUMB_SPOIL(joint, JointDefinition, axis.y),
        PLUMB_SPOIL(joint, JointDefinition, referenceAngle),
        PLUMB_SPOIL(joint, JointDefinition, length),
        PLUMB_SPOIL(joint, JointDefinition, ratio),
        PLUMB_SPOIL(joint, JointDefinition, groundA.x),
        PLUMB_SPOIL(joint, JointDefinition, groundB.y),
        PLUMB_SPOIL(joint, JointDefinition, target.x),
        PLUMB_SPOIL(joint, JointDefinition, target.y),
        PLUMB_SPOIL(joint, JointDefinition, offset.x),
        PLUMB_SPOIL(joint, JointDefinition, limit.lower),
        PLUMB_SPOIL(joint, JointDefinition, limit.upper),
        PLUMB_SPOIL(joint, JointDefinition, motor.speed),
        PLUMB_SPOIL(joint, JointDefinition, spring.hertz),
        PLUMB_SPOIL(joint, JointDefinition, spring.dampingRatio),
        PLUMB_SPOIL(joint, JointDefinition, spring.rest),
        PLUMB_SPOIL(joint, JointDefinition, hertz),
        PLUMB_SPOIL(joint, JointDefinition, dampingRatio),
    };
}

std::vector<Named> setters() {
    return {
        PLUMB_CALL(setPosition(p.world, p.body, {d, 0.0}, 0.0f)),
        PLUMB_CALL(setPosition(p.world, p.body, {0.0, d}, 0.0f)),
        PLUMB_CALL(setPosition(p.world, p.body, {}, f)),
        PLUMB_CALL(setVelocity(p.world, p.body, {f, 0.0f})),
        PLUMB_CALL(setVelocity(p.world, p.body, {0.0f, f})),
        PLUMB_CALL(setAngularVelocity(p.world, p.body, f)),
        PLUMB_CALL(setAcceleration(p.world, p.body, {f, 0.0f})),
        PLUMB_CALL(setAcceleration(p.world, p.body, {0.0f, f})),
        PLUMB_CALL(setGravityScale(p.world, p.body, f)),
        PLUMB_CALL(setDrag(p.world, p.body, f, 0.0f)),
        PLUMB_CALL(setDrag(p.world, p.body, 0.0f, f)),
        PLUMB_CALL(setMass(p.world, p.body, f)),
        PLUMB_CALL(applyForce(p.world, p.body, {0.0f, f})),
        PLUMB_CALL(applyForceAt(p.world, p.body, {f, 0.0f}, {})),
        PLUMB_CALL(applyForceAt(p.world, p.body, {1.0f, 0.0f}, {0.0, d})),
        PLUMB_CALL(applyTorque(p.world, p.body, f)),
        PLUMB_CALL(applyImpulse(p.world, p.body, {f, f})),
        PLUMB_CALL(applyImpulseAt(p.world, p.body, {f, 0.0f}, {})),
        PLUMB_CALL(applyImpulseAt(p.world, p.body, {1.0f, 0.0f}, {d, 0.0})),
        PLUMB_CALL(moveTo(p.world, p.kinematic, {d, 0.0}, 0.0f, kTick)),
        PLUMB_CALL(moveTo(p.world, p.kinematic, {0.0, d}, 0.0f, kTick)),
        PLUMB_CALL(moveTo(p.world, p.kinematic, {}, f, kTick)),
        PLUMB_CALL(moveTo(p.world, p.kinematic, {}, 0.0f, f)),
        PLUMB_CALL(setFriction(p.world, p.shape, f)),
        PLUMB_CALL(setBounciness(p.world, p.shape, f)),
        PLUMB_CALL(setSurfaceSpeed(p.world, p.shape, f)),
        PLUMB_CALL(setMotorSpeed(p.world, p.joint, f)),
        PLUMB_CALL(setTarget(p.world, p.joint, {d, 0.0})),
        PLUMB_CALL(setTarget(p.world, p.joint, {0.0, d})),
        PLUMB_CALL(createShapes(p.world, p.body, std::array{circle(1.0f), circle(f)},
                                std::array{ShapeDefinition{}, ShapeDefinition{}})),
        PLUMB_CALL(createShapes(p.world, p.body, std::array{circle(1.0f), circle(1.0f)},
                                std::array{ShapeDefinition{}, ShapeDefinition{.density = f}})),
        PLUMB_CALL(createPolygon(p.world, p.body,
                                 std::array<Vec2, 3>{Vec2{f, 0.0f}, Vec2{1.0f, 0.0f}, Vec2{0.0f, 1.0f}})),
        PLUMB_CALL(createPolygon(p.world, p.body,
                                 std::array<Vec2, 3>{Vec2{}, Vec2{1.0f, 0.0f}, Vec2{0.0f, 1.0f}}, f)),
        PLUMB_CALL(
            createChain(p.world, p.body, std::array<Vec2, 3>{Vec2{}, Vec2{1.0f, f}, Vec2{0.0f, 1.0f}}, true)),
    };
}

void expectRefused(const std::vector<Named>& attempts) {
    Samples patient;
    ASSERT_TRUE(alive(patient.world, patient.shape));
    const std::uint64_t before = hashOf(patient.world);
    for (const double bad : {kNan, kInf, -kInf, 1.0e300, -1.0e300}) {
        for (const Named& one : attempts) {
            const std::optional<Error> error = one.attempt(patient, bad);
            ASSERT_TRUE(error.has_value()) << one.name << " took " << bad;
            EXPECT_FALSE(error->where.empty()) << one.name;
            EXPECT_FALSE(error->what.empty()) << one.name;
            EXPECT_FALSE(error->remedy.empty()) << one.name;
            ASSERT_EQ(hashOf(patient.world), before) << one.name << " changed the world for " << bad;
        }
    }
    for (int i = 0; i < 30; ++i) step(patient.world, kTick);
    EXPECT_TRUE(isSound(patient.world));
}

}  // namespace

TEST(BadInput, creationRejectsNumbersThatAreNotFinite) { expectRefused(creators()); }

TEST(BadInput, settersRejectNumbersThatAreNotFinite) { expectRefused(setters()); }

TEST(BadInput, negativeSizesAndRatesAreRejected) {
    const std::vector<Named> attempts = {
        PLUMB_SPOIL(body, BodyDefinition, linearDrag),
        PLUMB_SPOIL(body, BodyDefinition, angularDrag),
        PLUMB_SPOIL(body, BodyDefinition, sleepSpeed),
        PLUMB_SPOIL(shape, ShapeDefinition, density),
        PLUMB_SPOIL(shape, ShapeDefinition, friction),
        PLUMB_SPOIL(shape, ShapeDefinition, bounciness),
        PLUMB_SPOIL(shape, ShapeDefinition, rollingResistance),
        PLUMB_OUTLINE(circle(1.0f), radius),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), b.x),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), radius),
        PLUMB_SPOIL(joint, JointDefinition, length),
        PLUMB_SPOIL(joint, JointDefinition, motor.maxForce),
        PLUMB_SPOIL(joint, JointDefinition, spring.hertz),
        PLUMB_SPOIL(joint, JointDefinition, maxForce),
        PLUMB_SPOIL(joint, JointDefinition, maxTorque),
        PLUMB_SPOIL(joint, JointDefinition, breakForce),
        PLUMB_SPOIL(joint, JointDefinition, breakTorque),
        PLUMB_SPOIL(joint, JointDefinition, hertz),
        PLUMB_CALL(setDrag(p.world, p.body, f, 0.0f)),
        PLUMB_CALL(setMass(p.world, p.body, f)),
        PLUMB_CALL(setFriction(p.world, p.shape, f)),
        PLUMB_CALL(setBounciness(p.world, p.shape, f)),
        PLUMB_CALL(moveTo(p.world, p.kinematic, {}, 0.0f, f)),
    };
    Samples patient;
    for (const Named& one : attempts) EXPECT_TRUE(one.attempt(patient, -1.0).has_value()) << one.name;
}

TEST(BadInput, strengthsMayBeInfiniteButNotNaN) {
    const std::vector<Named> attempts = {
        PLUMB_SPOIL(joint, JointDefinition, motor.maxForce), PLUMB_SPOIL(joint, JointDefinition, maxForce),
        PLUMB_SPOIL(joint, JointDefinition, maxTorque),      PLUMB_SPOIL(joint, JointDefinition, breakForce),
        PLUMB_SPOIL(joint, JointDefinition, breakTorque),
    };
    for (const Named& one : attempts) {
        Samples patient;
        EXPECT_TRUE(one.attempt(patient, kNan).has_value()) << one.name;
        EXPECT_TRUE(one.attempt(patient, -kInf).has_value()) << one.name;
        EXPECT_FALSE(one.attempt(patient, kInf).has_value()) << one.name;
    }
}

TEST(BadInput, shapesWithoutASizeAreRejected) {
    const std::vector<Named> attempts = {
        PLUMB_OUTLINE(circle(1.0f), radius),
        PLUMB_OUTLINE(capsule({}, {1.0f, 0.0f}, 1.0f), radius),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), b.x),
        PLUMB_OUTLINE(box({1.0f, 1.0f}), b.y),
        PLUMB_OUTLINE(segment({}, {1.0f, 0.0f}), b.x),
        PLUMB_CALL(createPolygon(p.world, p.body,
                                 std::array<Vec2, 3>{Vec2{f, f}, Vec2{1.0f, 0.0f}, Vec2{2.0f, 0.0f}})),
        PLUMB_CALL(moveTo(p.world, p.kinematic, {}, 0.0f, f)),
    };
    Samples patient;
    const std::uint64_t before = hashOf(patient.world);
    for (const Named& one : attempts) EXPECT_TRUE(one.attempt(patient, 0.0).has_value()) << one.name;
    EXPECT_EQ(hashOf(patient.world), before);
}

TEST(BadInput, aOneWayShapeNeedsADirection) {
    Samples patient;
    const auto made =
        createShape(patient.world, patient.body, circle(1.0f), {.oneWay = true, .oneWayDirection = {}});
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().text().find("oneWayDirection"), std::string::npos);
}

TEST(BadInput, messagesContainNumbersAsPassed) {
    Samples patient;
    const auto made = createShape(patient.world, patient.body, circle(0.00003f));
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().what, "expected 5e-05 to 1e+06 m, found 3e-05");
}

TEST(BadInput, numbersCloseToZeroStayFinite) {
    for (const float tiny : {1.0e-45f, 1.0e-38f, 1.0e-30f, 1.0e-20f}) {
        SCOPED_TRACE(tiny);
        World world = makePit(6, 1);
        const BodyId light = addBody(world, BodyKind::Dynamic, {0.0, 3.0});
        static_cast<void>(createShape(world, light, box({0.5f, 0.5f}), {.density = tiny}));
        const BodyId set = addBody(world, BodyKind::Dynamic, {2.0, 3.0});
        static_cast<void>(createShape(world, set, circle(0.5f)));
        static_cast<void>(setMass(world, set, tiny));
        static_cast<void>(setDrag(world, set, tiny, tiny));
        static_cast<void>(applyForce(world, light, {1.0f, 0.0f}));
        static_cast<void>(applyImpulse(world, set, {0.0f, 1.0f}));
        for (int i = 0; i < 60; ++i) step(world, kTick);
        EXPECT_TRUE(isSound(world));
        EXPECT_TRUE(std::isfinite(massOf(world, light)) && massOf(world, light) > 0.0f);
        EXPECT_TRUE(std::isfinite(world.bodies.mass[light.index].inverseMass));
        EXPECT_TRUE(std::isfinite(world.bodies.mass[set.index].inverseMass));
        EXPECT_TRUE(std::isfinite(world.bodies.mass[light.index].inverseInertia));
    }
}

TEST(BadInput, invalidSettingsAreClamped) {
    float Settings::*const members[] = {&Settings::contactStiffness,
                                        &Settings::jointStiffness,
                                        &Settings::contactDampingRatio,
                                        &Settings::jointDampingRatio,
                                        &Settings::pushSpeed,
                                        &Settings::deepPushRate,
                                        &Settings::slop,
                                        &Settings::boundsMargin,
                                        &Settings::speculativeDistance,
                                        &Settings::recycleDistance,
                                        &Settings::bounceSpeed,
                                        &Settings::sleepTime,
                                        &Settings::maxSpeed,
                                        &Settings::tolerance};
    for (const double bad : {kNan, kInf, -kInf, -1.0}) {
        SCOPED_TRACE(bad);
        for (float Settings::*const member : members) {
            World world = makePit(6, 1);
            static_cast<void>(*createJoint(world, {.a = {1, 1}, .b = {2, 1}}));
            world.settings.*member = static_cast<float>(bad);
            for (int i = 0; i < 30; ++i) step(world, kTick);
            EXPECT_GE(world.settings.*member, 0.0f);
            EXPECT_TRUE(std::isfinite(world.settings.*member));
            EXPECT_TRUE(isSound(world));
            EXPECT_TRUE(world.quarantined.empty());
        }
        World world = makePit(6, 1);
        world.settings.gravity = {static_cast<float>(bad), static_cast<float>(bad)};
        step(world, kTick);
        EXPECT_TRUE(isFinite(world.settings.gravity));
    }
}

TEST(BadInput, invalidQualitiesAreClamped) {
    for (const int bad : {-128, -1, 7, 127}) {
        SCOPED_TRACE(bad);
        World asked = makePit(6, 1), meant = makePit(6, 1);
        for (World* world : {&asked, &meant})
            // island qualities are used only if a body has its own quality
            ASSERT_TRUE(setQuality(*world, {1, 1}, 1).ok());
        asked.settings.quality = static_cast<Quality>(bad);
        meant.settings.quality = bad < 0 ? Quality{0} : kMaxQuality;
        for (int i = 0; i < 5; ++i) step(asked, kTick), step(meant, kTick);
        EXPECT_EQ(hashOf(asked), hashOf(meant));
    }
}

TEST(BadInput, predictionsAreFiniteForAnyTime) {
    Playground scene;
    const BodyId crate = scene.crate({1.0, 2.0});
    ASSERT_TRUE(setAngularVelocity(scene.world, crate, 3.0f).ok());
    ASSERT_TRUE(setVelocity(scene.world, crate, {5.0f, 5.0f}).ok());
    ASSERT_TRUE(setDrag(scene.world, crate, 1.0e-3f, 1.0e6f).ok());
    for (const double bad : {kNan, kInf, -kInf, 1.0e30}) {
        const Frame ahead = predictTransform(scene.world, crate, static_cast<float>(bad));
        EXPECT_TRUE(isFinite(ahead.position)) << bad;
        EXPECT_TRUE(std::isfinite(ahead.rotation.cos) && std::isfinite(ahead.rotation.sin)) << bad;
    }
    EXPECT_EQ(predictTransform(scene.world, crate, static_cast<float>(kNan)).position, (Vec2{1.0f, 2.0f}));
}

TEST(BadInput, invalidKindsAreRejected) {
    Samples patient;
    World& world = patient.world;
    BodyDefinition noKind;
    noKind.kind = BodyKind::None;
    EXPECT_FALSE(createBody(world, noKind).ok());
    noKind.kind = static_cast<BodyKind>(77);
    EXPECT_FALSE(createBody(world, noKind).ok());
    JointDefinition unknown{.a = patient.body, .b = patient.other};
    unknown.kind = JointKind::Count;
    EXPECT_FALSE(createJoint(world, unknown).ok());
    unknown.kind = static_cast<JointKind>(200);
    EXPECT_FALSE(createJoint(world, unknown).ok());
    Geometry strange = circle(1.0f);
    for (const ShapeKind kind : {ShapeKind::Polygon, ShapeKind::Count, static_cast<ShapeKind>(99)}) {
        strange.kind = kind;
        EXPECT_FALSE(createShape(world, patient.body, strange).ok());
    }
    EXPECT_FALSE(createJoint(world, {.a = patient.body, .b = patient.body}).ok());
    EXPECT_FALSE(createJoint(world, {.a = patient.body, .b = {77, 1}}).ok());
    EXPECT_FALSE(createPolygon(world, patient.body, {}).ok());
    EXPECT_FALSE(createChain(world, patient.body, {}, true).ok());
    EXPECT_FALSE(setQuality(world, patient.body, 100).ok());
    EXPECT_FALSE(setQuality(world, patient.body, -2).ok());
}

TEST(BadInput, idsOfDestroyedObjectsDoNothing) {
    Samples patient;
    World& world = patient.world;
    destroyBody(world, patient.body);
    EXPECT_FALSE(alive(world, patient.body));
    EXPECT_FALSE(alive(world, patient.shape));
    EXPECT_FALSE(alive(world, patient.joint));
    EXPECT_EQ(createPolygon(world, patient.body, {}).error().where, "createPolygon");
    EXPECT_EQ(createChain(world, patient.body, {}, true).error().where, "createChain");
    EXPECT_EQ(createShapes(world, patient.body, {}, {}).error().where, "createShapes");
    const std::uint64_t before = hashOf(world);
    for (const BodyId id : {patient.body, BodyId{}, BodyId{9999, 1}, BodyId{kNone, 1}}) {
        EXPECT_FALSE(setPosition(world, id, {}, 0.0f).ok());
        EXPECT_FALSE(setVelocity(world, id, {}).ok());
        EXPECT_FALSE(applyImpulse(world, id, {}).ok());
        EXPECT_FALSE(applyForceAt(world, id, {}, {}).ok());
        EXPECT_FALSE(applyImpulseAt(world, id, {}, {}).ok());
        EXPECT_FALSE(setMass(world, id, 1.0f).ok());
        EXPECT_FALSE(moveTo(world, id, {}, 0.0f, 1.0f).ok());
        EXPECT_FALSE(createShape(world, id, circle(1.0f)).ok());
        EXPECT_FALSE(createJoint(world, {.a = id, .b = patient.other}).ok());
        setAwake(world, id, true);
        setFixedRotation(world, id, true);
        setBullet(world, id, true);
        destroyBody(world, id);
    }
    EXPECT_FALSE(setFriction(world, patient.shape, 1.0f).ok());
    EXPECT_FALSE(setBounciness(world, patient.shape, 1.0f).ok());
    EXPECT_FALSE(setSurfaceSpeed(world, patient.shape, 1.0f).ok());
    setFilter(world, patient.shape, 1, 1, 0);
    destroyShape(world, patient.shape);
    destroyJoint(world, patient.joint);
    EXPECT_FALSE(setMotorSpeed(world, patient.joint, 1.0f).ok());
    EXPECT_FALSE(setTarget(world, patient.joint, {}).ok());
    EXPECT_EQ(hashOf(world), before);
}

TEST(BadInput, gearsWithoutValidJointsAreRejected) {
    Samples patient;
    const auto jointOf = [&](JointKind kind) {
        return *createJoint(patient.world, {.kind = kind, .a = patient.body, .b = patient.other});
    };
    const JointId hinge = jointOf(JointKind::Revolute), slider = jointOf(JointKind::Prismatic);
    const auto gear = [&](JointId a, JointId b) {
        return createJoint(
            patient.world,
            {.kind = JointKind::Gear, .a = patient.body, .b = patient.other, .jointA = a, .jointB = b});
    };
    EXPECT_TRUE(gear(hinge, slider).ok());
    EXPECT_FALSE(gear(hinge, jointOf(JointKind::Distance)).ok());
    EXPECT_FALSE(gear(*gear(hinge, slider), slider).ok());
}

TEST(BadInput, objectsMayBeDestroyedInAnyOrder) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world = makePit(20, seed);
        std::vector<BodyId> bodies;
        std::vector<ShapeId> shapes;
        std::vector<JointId> joints;
        for (std::uint32_t i = 0; i < world.bodies.size(); ++i) bodies.push_back({i, 1});
        for (std::uint32_t i = 0; i < world.shapes.size(); ++i) shapes.push_back({i, 1});
        for (std::uint32_t i = 2; i < bodies.size(); i += 2)
            joints.push_back(*createJoint(world, {.a = bodies[i], .b = bodies[i - 1]}));
        for (int i = 0; i < 40; ++i) {
            const std::uint32_t kind = random.below(3);
            if (kind == 0)
                destroyBody(world, bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]);
            if (kind == 1)
                destroyShape(world, shapes[random.below(static_cast<std::uint32_t>(shapes.size()))]);
            if (kind == 2)
                destroyJoint(world, joints[random.below(static_cast<std::uint32_t>(joints.size()))]);
            if (random.below(3) != 0) step(world, kTick);
            ASSERT_TRUE(isSound(world));
        }
        for (const BodyId id : bodies) destroyBody(world, id);
        step(world, kTick);
        EXPECT_EQ(bodyCount(world), 0u);
        EXPECT_TRUE(world.contacts.empty());
        EXPECT_TRUE(world.awake.empty());
        EXPECT_TRUE(world.joints.awake.empty());
        for (const std::uint32_t requesters : world.manifest.requesters) EXPECT_EQ(requesters, 0u);
        EXPECT_EQ(world.shapes.free.size(), world.shapes.size());
    }
}
