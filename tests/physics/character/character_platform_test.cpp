#include <cmath>
#include <vector>

#include "physics/model/bodies.hpp"
#include "physics/model/shapes.hpp"
#include "tests/physics/support/character_course.hpp"

namespace plumb::physics {
namespace {

enum class Ride { Linear, Sine, Rotating, Elevator, Wheel, Count };
constexpr const char* kRides[] = {"linear", "sine", "rotating", "elevator", "wheel"};

/// Sets the velocity of a platform for tick `i`.
void drive(World& world, BodyId platform, Ride ride, int i) {
    const float now = static_cast<float>(i) * kTick, next = now + kTick;
    Result<Done> done = Done{};
    switch (ride) {
        case Ride::Linear: done = setVelocity(world, platform, {2.0f, 0.0f}); break;
        case Ride::Sine:
            done = moveTo(world, platform, Vec2{4.0f * sine(2.0f * next), 1.5f * sine(3.0f * next)}, 0.0f,
                          kTick);
            break;
        case Ride::Rotating: done = setAngularVelocity(world, platform, 0.8f * cosine(2.0f * now)); break;
        case Ride::Elevator:
            done = setVelocity(world, platform, {0.0f, i / 60 % 2 == 0 ? -20.0f : 20.0f});
            break;
        default:
            done = moveTo(world, platform, Vec2{5.0f * sine(next), 5.0f - 5.0f * cosine(next)}, 0.0f, kTick);
    }
    EXPECT_TRUE(done.ok());
}

/// Point of the platform's top under the middle of a character, in the platform's frame, m.
Vec2 footOn(const World& world, BodyId platform, const CharacterController& rider) {
    const Rot rotation = rotationOf(world, platform);
    const Vec2 arm = rider.position() - centreOf(world, platform);
    const Vec2 normal = rotate(rotation, {0.0f, -1.0f});
    const float height = (dot(arm, normal) - 0.25f) / -normal.y;
    return unrotate(rotation, arm + Vec2{0.0f, height});
}

TEST(CharacterRide, aRiderDoesNotDriftInTenMinutes) {
    constexpr int kTicks = 36000;
    for (int ride = 0; ride < static_cast<int>(Ride::Count); ++ride) {
        for (const Figure figure : {Figure::Box, Figure::Capsule}) {
            SCOPED_TRACE(kRides[ride]);
            Course course;
            const bool oneWay = ride % 2 == 0;
            const BodyId platform = course.block(BodyKind::Kinematic, {}, {3.0f, 0.25f}, {.oneWay = oneWay});
            CharacterController rider = course.character(definitionOf(figure), {0.5, -1.3});
            course.run(rider, 30);
            ASSERT_EQ(rider.ground().body, platform);
            const Vec2 foot = footOn(course.world, platform, rider);
            float drift = 0.0f;
            for (int i = 0; i < kTicks; ++i) {
                drive(course.world, platform, static_cast<Ride>(ride), i);
                course.tick(rider);
                ASSERT_TRUE(rider.grounded()) << i;
                drift = std::max(drift, length(footOn(course.world, platform, rider) - foot));
            }
            EXPECT_LE(drift, 1.0e-4f);
            RecordProperty(kRides[ride], std::to_string(drift));
        }
    }
}

TEST(CharacterRide, aJumpKeepsTheVelocityOfThePlatform) {
    for (const Vec2 velocity : {Vec2{3.0f, 0.0f}, Vec2{0.0f, -20.0f}, Vec2{-2.0f, 4.0f}, Vec2{0.0f, 20.0f}}) {
        SCOPED_TRACE(velocity.y);
        Course course;
        const BodyId platform = course.block(BodyKind::Kinematic, {}, {3.0f, 0.25f});
        CharacterController rider = course.character({}, {0.5, -1.3});
        course.run(rider, 30);
        ASSERT_TRUE(setVelocity(course.world, platform, velocity).ok());
        course.run(rider, 30);
        const WorldPosition start = rider.position();
        ASSERT_TRUE(rider.jump(6.0f).ok());
        EXPECT_TRUE(course.tick(rider).leftGround);
        EXPECT_NEAR(rider.velocity().x, velocity.x, 1.0e-4f);
        EXPECT_NEAR(rider.velocity().y, velocity.y - 6.0f + 10.0f * kTick, 1.0e-4f);
        course.run(rider, 29);
        // Free flight with the sum of the velocities of platform and jump.
        EXPECT_NEAR(rider.position().x - start.x, static_cast<double>(velocity.x) * 0.5, 1.0e-4);
        EXPECT_NEAR(rider.position().y - start.y, (static_cast<double>(velocity.y) - 6.0) * 0.5 + 5.0 * 0.25,
                    1.0e-4);
    }
}

TEST(CharacterRide, walkingOffKeepsTheVelocityOfThePlatform) {
    Course course;
    const BodyId platform = course.block(BodyKind::Kinematic, {}, {3.0f, 0.25f});
    CharacterController rider = course.character({}, {2.0, -1.3});
    course.run(rider, 30);
    ASSERT_TRUE(setVelocity(course.world, platform, {2.0f, 0.0f}).ok());
    for (int i = 0; i < 60 && rider.grounded(); ++i) course.walk(rider, 3.0f, 1);
    EXPECT_FALSE(rider.grounded());
    EXPECT_NEAR(rider.velocity().x, 5.0f, 1.0e-4f);
}

TEST(CharacterRide, aConveyorMovesItLikeABody) {
    Course course;
    const BodyId belt = course.block(BodyKind::Static, {0.0, 1.0}, {50.0f, 1.0f}, {.surfaceSpeed = 2.0f});
    const BodyId crate = course.body(BodyKind::Dynamic, {5.0, -0.5});
    ASSERT_TRUE(createShape(course.world, crate, box({0.5f, 0.5f})).ok());
    CharacterController one = course.character({}, {-5.0, -1.3});
    course.run(one, 60);
    const double before = one.position().x, crateBefore = centreOf(course.world, crate).x;
    course.run(one, 60);
    EXPECT_NEAR(one.position().x - before, centreOf(course.world, crate).x - crateBefore, 0.02);
    EXPECT_NEAR(std::fabs(one.position().x - before), 2.0, 0.02);
    EXPECT_EQ(one.ground().body, belt);
}

TEST(CharacterPush, isSqueezedByACrusherAndPushedByAWall) {
    for (const Figure figure : kFigures) {
        SCOPED_TRACE(static_cast<int>(figure));
        Course course;
        course.wall({0.0, 1.0}, {50.0f, 1.0f});
        const BodyId lid = course.block(BodyKind::Kinematic, {0.0, -4.0}, {2.0f, 1.0f});
        CharacterController one = course.character(definitionOf(figure), {0.0, -1.5});
        course.run(one, 30);
        const WorldPosition rests = one.position();
        const float room = 3.0f - 2.0f * feetOf(one.definition().outline);
        ASSERT_TRUE(setVelocity(course.world, lid, {0.0f, 1.0f}).ok());
        for (int i = 1; static_cast<float>(i) * kTick < room + 0.2f; ++i) {
            const CharacterMotion motion = course.tick(one);
            const float left = room - static_cast<float>(i) * kTick;
            if (left > 2.0f * kGap) {
                EXPECT_FALSE(motion.squeezedBy) << i;
            }
            if (left < -0.02f) {
                EXPECT_EQ(motion.squeezedBy.body, lid) << i;
            }
            EXPECT_NEAR(one.position().y, rests.y, 0.01);
        }
        // One wall pushes the character against another one behind it.
        ASSERT_TRUE(setVelocity(course.world, lid, {0.0f, 0.0f}).ok());
        ASSERT_TRUE(one.setPosition({10.0, rests.y}).ok());
        const BodyId ram = course.block(BodyKind::Kinematic, {8.0, -3.0}, {0.5f, 2.5f});
        ASSERT_TRUE(setVelocity(course.world, ram, {6.0f, 0.0f}).ok());
        const float half = one.definition().outline.kind == ShapeKind::Circle ? 0.5f : 0.4f;
        for (int i = 0; i < 60; ++i) {
            EXPECT_FALSE(course.tick(one).squeezedBy);
            EXPECT_GT(one.position().x,
                      centreOf(course.world, ram).x + static_cast<double>(0.5f + half) - 1.0e-4);
        }
        EXPECT_NEAR(one.position().x, centreOf(course.world, ram).x + static_cast<double>(0.5f + half),
                    3.0e-3);
        EXPECT_TRUE(one.grounded());
        course.wall({16.0, -5.0}, {1.0f, 8.0f});
        bool squeezed = false;
        for (int i = 0; i < 30; ++i) squeezed = course.tick(one).squeezedBy || squeezed;
        EXPECT_TRUE(squeezed);
        EXPECT_LT(one.position().x, 15.0 - static_cast<double>(half) + 2.0 * static_cast<double>(kGap));
    }
}

TEST(CharacterPush, pushesDynamicBodiesUpToItsPushMass) {
    for (const float mass : {10.0f, 100.0f, 1000.0f}) {
        SCOPED_TRACE(mass);
        Course course;
        course.block(BodyKind::Static, {0.0, 1.0}, {50.0f, 1.0f}, {.friction = 0.0f});
        const BodyId crate = course.body(BodyKind::Dynamic, {2.0, -0.5});
        ASSERT_TRUE(createShape(course.world, crate, box({0.5f, 0.5f}), {.friction = 0.0f}).ok());
        ASSERT_TRUE(setMass(course.world, crate, mass).ok());
        setFixedRotation(course.world, crate, true);
        CharacterController one = course.character({}, {0.0, -1.3});
        course.run(one, 30);
        course.walk(one, 3.0f, 20);
        const float before = velocityOf(course.world, crate).x;
        course.walk(one, 3.0f, 30);
        const float gained = velocityOf(course.world, crate).x - before;
        EXPECT_NEAR(before, 0.0f, 1.0e-6f);
        // The push force acts for 28 ticks of contact, after a path of 1.099 m, or until the crate has the
        // character's velocity.
        const float most = one.definition().pushForce / mass * 28.0f * kTick;
        if (mass > one.definition().pushMass) {
            EXPECT_NEAR(gained, 0.0f, 1.0e-6f);
        } else {
            EXPECT_NEAR(gained, std::min(most, 3.0f), 0.1f * std::min(most, 3.0f));
        }
        EXPECT_LT(one.position().x + 0.9, centreOf(course.world, crate).x + 1.0e-3);
    }
}

TEST(CharacterPush, itsWeightActsOnTheBodyBelow) {
    Course course;
    course.world.settings.sleeping = false;
    const BodyId beam = course.body(BodyKind::Dynamic, {0.0, 0.0});
    ASSERT_TRUE(createShape(course.world, beam, box({2.0f, 0.1f})).ok());
    ASSERT_TRUE(setGravityScale(course.world, beam, 0.0f).ok());
    ASSERT_TRUE(setMass(course.world, beam, 20.0f).ok());
    setFixedRotation(course.world, beam, true);
    CharacterDefinition definition;
    definition.weight = 10.0f;
    CharacterController one = course.character(definition, {0.0, -1.1});
    while (!one.grounded()) course.tick(one);
    const float before = velocityOf(course.world, beam).y;
    course.run(one, 60);
    EXPECT_NEAR(velocityOf(course.world, beam).y - before, 10.0f * 10.0f / 20.0f, 0.1f);
    EXPECT_TRUE(one.grounded());
}

}  // namespace
}  // namespace plumb::physics
