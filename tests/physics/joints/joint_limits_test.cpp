#include <array>
#include <limits>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

constexpr float kMass = 2.0f;   // mass of the driven body, kg
constexpr float kSpeed = 8.0f;  // speed of the motors, rad/s or m/s

/// A joint whose motor drives its coordinate back and forth between two limits, with or against gravity.
struct Driven {
    std::string_view name;
    JointDefinition (*define)(JointWorld& scene);
    float (*value)(const JointWorld& scene, BodyId body);        ///< joint coordinate, rad or m
    float (*load)(const JointWorld& scene, BodyId, JointId id);  ///< load reported by the joint, N or N m
    float (*weight)(float value);                                ///< expected load of the weight by formula
};

JointDefinition defineHinge(JointWorld& scene) {
    JointDefinition definition =
        scene.define(JointKind::Revolute, scene.ground, scene.disc({0.5, 0.0}, kMass), {});
    definition.limit = {true, -0.5f, 0.25f};
    return definition;
}

JointDefinition defineHingeInLanes(JointWorld& scene) {
    scene.world.settings.directJoints = false;
    return defineHinge(scene);
}

JointDefinition defineSlider(JointWorld& scene) {
    JointDefinition definition =
        scene.define(JointKind::Prismatic, scene.ground, scene.disc({0.0, 0.0}, kMass), {});
    definition.axis = {0.0f, 1.0f};
    definition.limit = {true, -0.5f, 0.25f};
    return definition;
}

JointDefinition defineRod(JointWorld& scene) {
    JointDefinition definition =
        scene.define(JointKind::Distance, scene.ground, scene.disc({0.0, -1.0}, kMass), {0.0, -1.0});
    definition.anchorA = {};
    definition.limit = {true, 0.5f, 1.5f};
    return definition;
}

float angleOf(const JointWorld& scene, BodyId body) { return scene.angle(body); }
float torqueOf(const JointWorld& scene, BodyId, JointId id) { return jointTorque(scene.world, id); }
float forceOf(const JointWorld& scene, BodyId, JointId id) { return jointForce(scene.world, id).y; }

constexpr float kWeight = kMass * JointWorld::kGravity;
float leverOf(float angle) { return kWeight * 0.5f * std::cos(angle); }

constexpr std::array<Driven, 4> kDriven{{
    {"hinge", defineHinge, angleOf, torqueOf, leverOf},
    {"hinge in lanes", defineHingeInLanes, angleOf, torqueOf, leverOf},
    {"slider", defineSlider, [](const JointWorld& s, BodyId b) { return s.place(b).y; }, forceOf,
     [](float) { return kWeight; }},
    {"rod", defineRod, [](const JointWorld& s, BodyId b) { return length(s.place(b)); }, forceOf,
     [](float) { return kWeight; }},
}};

template <class Check>
void forEachDriven(Check&& check) {
    for (const Driven& driven : kDriven) {
        for (const float strength : {100.0f, 1.0e4f, 1.0e6f, std::numeric_limits<float>::infinity()}) {
            for (Quality quality = 0; quality <= 4; ++quality) {
                for (const float way : {1.0f, -1.0f}) {
                    SCOPED_TRACE(testing::Message() << driven.name << ", " << strength << " N, quality "
                                                    << int{quality} << ", way " << way);
                    JointWorld scene;
                    scene.world.settings.quality = quality;
                    JointDefinition definition = driven.define(scene);
                    definition.motor = {true, way * kSpeed, strength};
                    check(driven, scene, definition);
                }
            }
        }
    }
}

TEST(EachLimit, stopsAMotorOfAnyStrengthWithinASubstep) {
    forEachDriven([](const Driven& driven, JointWorld& scene, const JointDefinition& definition) {
        (void)scene.join(definition);
        const float substep = JointWorld::kDt / static_cast<float>(1 << scene.world.settings.quality);
        const float most = kSpeed * substep;
        for (int i = 0; i < 120; ++i) {
            scene.run(JointWorld::kDt);
            const float value = driven.value(scene, definition.b);
            ASSERT_LT(value, definition.limit.upper + most) << i;
            ASSERT_GT(value, definition.limit.lower - most) << i;
        }
    });
}

TEST(EachLimit, holdsAMotorOfAnyStrengthAndReportsItsLoad) {
    forEachDriven([](const Driven& driven, JointWorld& scene, const JointDefinition& definition) {
        const JointId joint = scene.join(definition);
        scene.run(2.0f);
        const float limit = definition.motor.speed > 0.0f ? definition.limit.upper : definition.limit.lower;
        EXPECT_NEAR(driven.value(scene, definition.b), limit, 0.01f);
        const float weight = driven.weight(limit);
        for (int i = 0; i < 60; ++i) {
            scene.run(JointWorld::kDt);
            ASSERT_NEAR(driven.load(scene, definition.b, joint), weight, 0.01f * weight) << i;
        }
        EXPECT_LT(length(velocityOf(scene.world, definition.b)), 0.001f);
    });
}

TEST(EachLimit, releasesAReversedMotorAtOnce) {
    forEachDriven([](const Driven& driven, JointWorld& scene, const JointDefinition& definition) {
        const JointId joint = scene.join(definition);
        scene.run(2.0f);
        const float speed = -0.1f * definition.motor.speed;
        ASSERT_TRUE(setMotorSpeed(scene.world, joint, speed).ok());
        const float before = driven.value(scene, definition.b);
        scene.run(0.25f);
        const float way = speed * 0.25f;
        EXPECT_NEAR(driven.value(scene, definition.b), before + way, 0.1f * std::fabs(way));
    });
}

TEST(Limits, ofAHingeAreWithinOneRevolution) {
    JointWorld scene;
    JointDefinition definition = defineHinge(scene);
    definition.limit = {true, -kPi, kPi};
    definition.spring = {true, 1.0f, 1.0f, kPi};
    const Result<JointId> joint = createJoint(scene.world, definition);
    ASSERT_TRUE(joint.ok());
    const auto refuses = [&](auto&& act) {
        const Result<Done> changed = change(scene.world, *joint, act);
        return !changed.ok() && changed.error().text().find("-pi to pi") != std::string::npos;
    };
    EXPECT_TRUE(refuses([](JointDefinition& d) { d.limit.lower = -3.2f; }));
    EXPECT_TRUE(refuses([](JointDefinition& d) { d.limit.upper = 3.2f; }));
    EXPECT_TRUE(refuses([](JointDefinition& d) { d.spring.rest = -3.2f; }));
    EXPECT_TRUE(change(scene.world, *joint, [](JointDefinition& d) { d.limit = {false, -9.0f, 9.0f}; }).ok());
    definition = defineSlider(scene);
    definition.limit = {true, -9.0f, 9.0f};
    EXPECT_TRUE(createJoint(scene.world, definition).ok());
}

}  // namespace
}  // namespace plumb::physics
