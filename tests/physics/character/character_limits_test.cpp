#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "physics/model/bodies.hpp"
#include "physics/model/shapes.hpp"
#include "tests/physics/support/character_course.hpp"
#include "tests/support/allocations.hpp"

namespace plumb::physics {
namespace {

bool overlapsAnything(Course& course, const CharacterController& one) {
    const auto hit = castShape(course.world, {one.definition().outline, one.position(), {}}, {});
    return hit && hit->separation < 0.0f;
}

TEST(CharacterLimits, leavesSolidsInWhichItIsPlaced) {
    for (int run = 0; run < runsToTry(100); ++run) {
        SCOPED_TRACE(run);
        Random random = Random::seeded(static_cast<std::uint64_t>(run));
        Course course;
        course.wall({0.0, 1.0}, {50.0f, 1.0f});
        for (int i = 0; i < 8; ++i) {  // a heap of tiles around the start position
            course.wall({static_cast<double>(i % 4), -0.5 - i / 4}, {0.5f, 0.5f});
        }
        CharacterController one = course.character(
            definitionOf(kFigures[run % 4]), Vec2{random.between(-2.0f, 5.0f), random.between(-4.0f, 0.5f)});
        for (int i = 0; i < 120; ++i) {
            EXPECT_FALSE(course.tick(one).squeezedBy);
            ASSERT_FALSE(overlapsAnything(course, one)) << i;
        }
        EXPECT_TRUE(one.grounded());
        EXPECT_LT(length(one.position() - WorldPosition{1.5, -1.0}), 8.0f);
    }
}

/// A character with a corner correction of 0.2 m that has just jumped from a floor under a block, which
/// overlaps its head by `reach` m on the given side.
CharacterController jumpUnderABlock(Course& course, float side, float reach) {
    course.wall({0.0, 1.0}, {50.0f, 1.0f});
    course.wall({static_cast<double>(side * (0.4f + 2.0f - reach)), -4.0}, {2.0f, 0.5f});
    CharacterController one = course.character({.cornerCorrection = 0.2f}, {0.0, -1.0});
    course.run(one, 30);
    EXPECT_TRUE(one.jump(10.0f).ok());
    return one;
}

TEST(CharacterLimits, cornerCorrectionMovesAHeadPastACorner) {
    for (const float reach : {0.1f, 0.19f, 0.3f}) {
        for (const float side : {-1.0f, 1.0f}) {
            SCOPED_TRACE(side * reach);
            Course course;
            CharacterController one = jumpUnderABlock(course, side, reach);
            bool hit = false;
            double highest = 0.0;
            for (int i = 0; i < 60; ++i) {
                hit = course.tick(one).ceiling || hit;
                highest = std::min(highest, one.position().y);
            }
            EXPECT_EQ(hit, reach > 0.2f);
            if (!hit) {
                EXPECT_NEAR(highest, -0.901 - 5.0, 0.02);
                EXPECT_NEAR(std::fabs(one.position().x), static_cast<double>(reach), 0.02);
            }
        }
    }
}

TEST(CharacterLimits, cornerCorrectionActsOnlyInTheDirectionOfMotion) {
    for (const float side : {-1.0f, 1.0f}) {
        for (const bool forwards : {true, false}) {
            SCOPED_TRACE(testing::Message() << side << (forwards ? " forwards" : " back"));
            Course course;
            // If `forwards`, the character moves away from the block, otherwise towards it. When they meet,
            // the block overlaps the head by 0.1 m.
            CharacterController one =
                jumpUnderABlock(course, forwards ? -side : side, 0.1f + (forwards ? 0.055f : -0.055f));
            bool hit = false;
            for (int i = 0; i < 30; ++i) {
                ASSERT_TRUE(one.setVelocity({0.3f * side, one.velocity().y}).ok());
                hit = course.tick(one).ceiling || hit;
            }
            EXPECT_EQ(hit, !forwards);
        }
    }
}

TEST(CharacterLimits, badNumbersAreRefusedWithAnError) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const auto refuses = [](const CharacterDefinition& definition) {
        const auto made = CharacterController::create(definition, {});
        return !made.ok() && !made.error().what.empty() && !made.error().remedy.empty();
    };
    EXPECT_FALSE(refuses({}));
    for (const float bad : {nan, inf, -inf, -1.0f}) {
        SCOPED_TRACE(bad);
        EXPECT_TRUE(refuses({.outline = circle(bad)}));
        EXPECT_TRUE(refuses({.outline = box({bad, 1.0f})}));
        EXPECT_TRUE(refuses({.outline = capsule({0.0f, -0.5f}, {0.0f, 0.5f}, bad)}));
        EXPECT_TRUE(refuses({.up = {bad, bad}}));
        EXPECT_TRUE(refuses({.steepest = bad}));
        EXPECT_TRUE(refuses({.stepHeight = bad}));
        EXPECT_TRUE(refuses({.snap = bad}));
        EXPECT_TRUE(refuses({.cornerCorrection = bad}));
        EXPECT_TRUE(refuses({.pushForce = bad}));
        EXPECT_TRUE(refuses({.pushMass = bad}));
        EXPECT_TRUE(refuses({.weight = bad}));
        EXPECT_TRUE(refuses({.gap = bad}));
    }
    EXPECT_TRUE(refuses({.outline = circle(0.0f)}));
    EXPECT_TRUE(refuses({.outline = box({0.0f, 0.0f})}));
    EXPECT_TRUE(refuses({.outline = segment({}, {1.0f, 0.0f})}));
    EXPECT_TRUE(refuses({.up = {}}));
    EXPECT_TRUE(refuses({.gravityScale = nan}));
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), 1.0e300, -std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(CharacterController::create({}, {bad, 0.0}).ok());
        EXPECT_FALSE(CharacterController::create({}, {})->setPosition({0.0, bad}).ok());
    }
    Course course;
    CharacterController one = course.character({}, {});
    for (const float bad : {nan, inf, -inf}) {
        EXPECT_FALSE(one.setVelocity({bad, 0.0f}).ok());
        EXPECT_FALSE(one.jump(bad).ok());
        EXPECT_FALSE(one.setDefinition({.snap = bad}).ok());
        one.update(course.world, bad);
        EXPECT_EQ(one.position(), WorldPosition{});
        EXPECT_EQ(one.velocity(), Vec2{});
    }
    one.update(course.world, 0.0f);
    one.update(course.world, -1.0f);
    EXPECT_EQ(one.position(), WorldPosition{});
}

/// Adds steps, a lift, loose crates and a one-way shelf.
void furnish(Course& course) {
    course.wall({0.0, 1.0}, {50.0f, 1.0f});
    course.wall({8.0, 0.0}, {1.0f, 0.2f});
    course.shelf(BodyKind::Kinematic, {-6.0, -1.5});
    const BodyId lift = course.block(BodyKind::Kinematic, {12.0, -0.2}, {1.5f, 0.2f});
    EXPECT_TRUE(setVelocity(course.world, lift, {0.0f, -1.0f}).ok());
    for (int i = 0; i < 4; ++i) {
        const BodyId crate = course.body(BodyKind::Dynamic, {2.0 + i, -0.6});
        EXPECT_TRUE(createShape(course.world, crate, box({0.4f, 0.4f})).ok());
    }
}

void play(Course& course, CharacterController& one, Random& random) {
    if (random.below(20) == 0 && one.grounded()) {
        EXPECT_TRUE(one.jump(random.between(2.0f, 9.0f)).ok());
    }
    if (random.below(40) == 0) static_cast<void>(one.dropThrough(course.world));
    EXPECT_TRUE(walkOn(one, random.below(3) == 0 ? -5.0f : 5.0f));
    course.tick(one);
}

TEST(CharacterLimits, aCopyWithItsWorldContinuesEqually) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Course course;
        furnish(course);
        CharacterDefinition definition = definitionOf(kFigures[seed % 4]);
        definition.stepHeight = 0.3f;
        definition.weight = 60.0f;
        CharacterController one = course.character(definition, {-3.0, -2.0});
        Random random = Random::seeded(seed);
        for (int i = 0; i < 200; ++i) play(course, one, random);
        Course copy{course};
        CharacterController twin = one;
        Random again = random;
        for (int i = 0; i < 200; ++i) {
            play(course, one, random);
            play(copy, twin, again);
            ASSERT_EQ(one.position(), twin.position()) << i;
            ASSERT_EQ(hashOf(course.world), hashOf(copy.world)) << i;
        }
        EXPECT_TRUE(std::isfinite(one.position().x) && std::isfinite(one.position().y));
    }
}

TEST(CharacterLimits, aTickAllocatesNothing) {
    Course course;
    furnish(course);
    CharacterController one = course.character({.stepHeight = 0.3f}, {-3.0, -2.0});
    std::size_t before = 0;
    for (int i = 0; i < 1600; ++i) {
        if (i % 60 == 0 && one.grounded()) {
            EXPECT_TRUE(one.jump(6.0f).ok());
        }
        EXPECT_TRUE(walkOn(one, i / 200 % 2 == 0 ? 4.0f : -4.0f));
        before = plumb::test::allocations().made;
        one.update(course.world, kTick);
        if (i > 800) {  // after two rounds all buffers have reached their final sizes
            ASSERT_EQ(plumb::test::allocations().made, before) << i;
        }
        step(course.world, kTick);
    }
}

TEST(CharacterLimits, isTheSameAThousandKilometresAway) {
    Course here, there;
    const double far = 1048576.0;
    CharacterController a = here.character({.stepHeight = 0.3f}, {-4.0, -2.0});
    CharacterController b = there.character({.stepHeight = 0.3f}, {far - 4.0, far - 2.0});
    for (int i = 0; i < 12; ++i) {
        here.wall({static_cast<double>(i), 1.0 - 0.25 * i}, {0.5f, 1.0f});
        there.wall({far + i, far + 1.0 - 0.25 * i}, {0.5f, 1.0f});
    }
    here.wall({-5.0, 1.0}, {5.0f, 1.0f}), there.wall({far - 5.0, far + 1.0}, {5.0f, 1.0f});
    for (int i = 0; i < 240; ++i) {
        here.walk(a, 3.0f, 1), there.walk(b, 3.0f, 1);
        ASSERT_EQ(a.grounded(), b.grounded()) << i;
        ASSERT_NEAR(a.position().x + far, b.position().x, 1.0e-4) << i;
        ASSERT_NEAR(a.position().y + far, b.position().y, 1.0e-4) << i;
    }
    EXPECT_LT(a.position().y, -2.0);
}

TEST(CharacterLimits, fallsIfItsGroundIsDestroyed) {
    Course course;
    const BodyId floor = course.wall({0.0, 1.0}, {5.0f, 1.0f});
    CharacterController one = course.character({}, {0.0, -1.5});
    course.run(one, 60);
    ASSERT_TRUE(one.grounded());
    destroyBody(course.world, floor);
    EXPECT_TRUE(course.tick(one).leftGround);
    course.run(one, 60);
    EXPECT_GT(one.position().y, 3.0);
}

TEST(CastShape, reportsTheInitialOverlapAndIgnoresTouchingSurfacesAlongThePath) {
    for (const double far : {0.0, 1048576.0}) {
        SCOPED_TRACE(far);
        Course course;
        course.wall({far, far + 1.0}, {4.0f, 1.0f});
        const auto cast = [&](double y, Vec2 displacement) {
            return castShape(course.world, {box({0.5f, 0.5f}), {far, far + y}, {}}, displacement);
        };
        // The shape overlaps the surface by 1/8 m: a cast in any direction hits at fraction 0, with a
        // normal that points out of the surface.
        for (const Vec2 displacement : {Vec2{}, Vec2{1.0f, 0.0f}, Vec2{0.0f, -1.0f}, Vec2{0.0f, 1.0f}}) {
            const auto hit = cast(-0.375, displacement);
            ASSERT_TRUE(hit.has_value());
            EXPECT_EQ(hit->fraction, 0.0f);
            EXPECT_NEAR(hit->separation, -0.125f, 1.0e-5f);
            EXPECT_NEAR(hit->normal.y, -1.0f, 1.0e-6f);
        }
        // At a distance of exactly 0 only a displacement into the surface is a hit.
        EXPECT_FALSE(cast(-0.5, {3.0f, 0.0f}).has_value());
        EXPECT_FALSE(cast(-0.5, {-3.0f, 0.0f}).has_value());
        EXPECT_FALSE(cast(-0.5, {0.0f, -1.0f}).has_value());
        EXPECT_FALSE(cast(-0.5, {}).has_value());
        ASSERT_TRUE(cast(-0.5, {1.0f, 0.1f}).has_value());
        EXPECT_EQ(cast(-0.5, {1.0f, 0.1f})->fraction, 0.0f);
        // A cast from a distance of 2 m.
        const auto hit = cast(-2.5, {0.0f, 4.0f});
        ASSERT_TRUE(hit.has_value());
        EXPECT_NEAR(hit->fraction, 0.5f, 1.0e-5f);
        EXPECT_NEAR(hit->separation, 2.0f, 1.0e-5f);
    }
}

}  // namespace
}  // namespace plumb::physics
