#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/physics/support/joint_world.hpp"

// Joints whose anchors are many body sizes away from the body, as in levels that give all anchors in world
// coordinates. Forces and torques are large there.

namespace plumb::physics {
namespace {

// Maximum speed at which joint errors are corrected, 10 times Settings::pushSpeed.
constexpr float kClosing = 30.0f;  // m/s

/// A box (`lift`) that a joint presses from below against two crates under a ceiling.
struct Press {
    JointWorld scene;
    Vec2 half;  // half extents of the lift, m
    BodyId lift;

    Press(Vec2 size, float density, float gap) : half{size} {
        lift = box({}, half, density);
        const auto above = static_cast<double>(half.y);
        BodyDefinition definition;
        definition.kind = BodyKind::Static;
        definition.position = {0.0, above + static_cast<double>(gap) + 1.0};
        (void)*createShape(scene.world, *createBody(scene.world, definition), physics::box({50.0f, 1.0f}));
        const float crate = 0.3f * gap;
        for (const double side : {-0.5, 0.5})
            (void)box({side * static_cast<double>(half.x), above + 1.1 * static_cast<double>(crate)},
                      {crate, crate}, density);
    }
    BodyId box(WorldPosition place, Vec2 size, float density) {
        BodyDefinition definition;
        definition.position = place;
        const BodyId body = *createBody(scene.world, definition);
        (void)*createShape(scene.world, body, physics::box(size), {.density = density});
        return body;
    }
    [[nodiscard]] float weight() const { return JointWorld::kGravity * massOf(scene.world, lift); }
    /// Runs for five seconds. @return the maximum speed of the lift, m/s
    float fastest() {
        float most = 0.0f;
        for (int i = 0; i < 300; ++i) {
            scene.run(JointWorld::kDt);
            most = std::max(most, length(velocityOf(scene.world, lift)));
        }
        EXPECT_TRUE(scene.world.quarantined.empty());
        return most;
    }
};

TEST(LongArms, doNotAffectALift) {
    float height = 0.0f;
    for (const float arm : {0.0f, 5.0f, 20.0f, 50.0f}) {
        SCOPED_TRACE(arm);
        Press press{{0.4f, 0.3f}, 1.0f, 2.0f};
        JointDefinition definition = press.scene.define(JointKind::Prismatic, press.scene.ground, press.lift,
                                                        {static_cast<double>(-arm), 0.0});
        definition.axis = {0.0f, 1.0f};
        definition.motor = {true, 4.0f, 400.0f};
        const JointId joint = press.scene.join(definition);

        EXPECT_LT(press.fastest(), 4.1f);
        if (arm == 0.0f) height = press.scene.place(press.lift).y;
        EXPECT_NEAR(press.scene.place(press.lift).y, height, 0.01f);
        EXPECT_NEAR(press.scene.angle(press.lift), 0.0f, 0.001f);
        // The ceiling pushes the lift at its center, the motor acts at the anchor.
        EXPECT_NEAR(jointForce(press.scene.world, joint).y, 400.0f, 1.0f);
        EXPECT_NEAR(jointTorque(press.scene.world, joint), 400.0f * arm, 8.0f * arm + 8.0f);
    }
}

struct RandomPress {
    Press press;
    JointDefinition definition;
    float arm;    // distance of the anchor from the lift, m
    float speed;  // speed of the motor, m/s
};

RandomPress pressOf(JointKind kind, std::uint64_t seed) {
    Random random{seed};
    const auto scaled = [&](float from, float ratio) { return from * std::pow(ratio, random.unit()); };
    const float size = scaled(0.1f, 10.0f), arm = size * scaled(1.0f, 50.0f), speed = scaled(0.5f, 10.0f);
    const Vec2 half{size, size * random.between(0.4f, 1.0f)};
    Press press{half, scaled(0.2f, 100.0f), size};
    const Vec2 direction = rotate(rotFromAngle(random.between(-kPi, kPi)), {1.0f, 0.0f});
    JointDefinition definition =
        press.scene.define(kind, press.scene.ground, press.lift, WorldPosition{} + arm * direction);
    definition.axis = {0.0f, 1.0f};
    definition.motor = {true, speed, press.weight() * scaled(2.0f, 50.0f)};
    return {std::move(press), definition, arm, speed};
}

TEST(LongArms, ofRandomSlidersAddNoSpeedBeyondThatOfTheirMotor) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        RandomPress slider = pressOf(JointKind::Prismatic, seed);
        (void)slider.press.scene.join(slider.definition);
        EXPECT_LT(slider.press.fastest(), 1.1f * slider.speed + 0.5f);
    }
}

TEST(LongArms, ofRandomWeldsToARisingBodyAddNoSpeedBeyondItsOwn) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        RandomPress weld = pressOf(JointKind::Weld, seed);
        World& world = weld.press.scene.world;
        BodyDefinition riser;
        riser.kind = BodyKind::Kinematic;
        riser.velocity = {0.0f, weld.speed};
        weld.definition.a = *createBody(world, riser);
        (void)weld.press.scene.join(weld.definition);
        // Allows for crates that overlap the lift and push it out.
        EXPECT_LT(weld.press.fastest(), 1.1f * weld.speed + 2.0f * world.settings.pushSpeed);
    }
}

/// Maximum speed (m/s) of a box with half extents `half` between a weld to the ground at `-arm` and a wheel
/// joint at `arm` to a body that moves away.
float fastestBetween(Vec2 half, float density, Vec2 arm, Vec2 velocity) {
    JointWorld scene;
    BodyDefinition definition;
    const BodyId body = *createBody(scene.world, definition);
    (void)*createShape(scene.world, body, box(half), {.density = density});
    definition.kind = BodyKind::Kinematic;
    definition.velocity = velocity;
    const BodyId leaving = *createBody(scene.world, definition);
    (void)scene.join(scene.define(JointKind::Weld, scene.ground, body, WorldPosition{} + -1.0f * arm));
    JointDefinition wheel = scene.define(JointKind::Wheel, leaving, body, WorldPosition{} + arm);
    wheel.limit = {true, 0.0f, 0.0f};
    wheel.spring = {true, 2.0f, 0.5f};
    (void)scene.join(wheel);
    float fastest = 0.0f;
    for (int i = 0; i < 300; ++i) {
        scene.run(JointWorld::kDt);
        fastest = std::max(fastest, length(velocityOf(scene.world, body)));
    }
    EXPECT_TRUE(scene.world.quarantined.empty());
    return fastest;
}

TEST(LongArms, ofContradictingJointsOnlyStretchThem) {
    const Vec2 velocity{1.5f, 2.3f};
    EXPECT_LT(fastestBetween({0.15f, 0.1f}, 1.5f, {8.0f, 0.0f}, velocity), 4.0f * length(velocity));
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random{seed};
        const float size = 0.1f * std::pow(10.0f, random.unit()), ratio = std::pow(50.0f, random.unit());
        const float speed = random.between(0.5f, 5.0f), density = 0.2f * std::pow(100.0f, random.unit());
        const Rot away = rotFromAngle(random.between(-kPi, kPi)),
                  moves = rotFromAngle(random.between(-kPi, kPi));
        const Vec2 half{size, size * random.between(0.4f, 1.0f)};
        // The speed amplified by a lever of the arm's length, plus what stretched joints release when they
        // flip. Regression: it reached Settings::maxSpeed, 4000 m/s.
        const float most = 3.0f * speed * (1.0f + ratio) + 4.0f * kClosing;
        EXPECT_LT(
            fastestBetween(half, density, rotate(away, {size * ratio, 0.0f}), rotate(moves, {speed, 0.0f})),
            most);
    }
}

}  // namespace
}  // namespace plumb::physics
