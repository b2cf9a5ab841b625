#include <cmath>
#include <limits>
#include <vector>

#include "physics/model/bodies.hpp"
#include "physics/model/shapes.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/terrain/terrain_body.hpp"
#include "tests/physics/support/character_course.hpp"

namespace plumb::physics {
namespace {

/// Adds a chain of slopes of at most `steepest` rad from x = -10 on, flat at both ends; returns the x
/// coordinate of its end.
double addHills(Course& course, Random& random, float steepest, int segments) {
    std::vector<Vec2> points{{-20.0f, 0.0f}, {-10.0f, 0.0f}};
    for (int i = 0; i < segments; ++i) {
        const float angle = random.between(-steepest, steepest);
        const float length = random.between(0.2f, 4.0f);
        points.push_back(points.back() + Vec2{length, length * sine(angle) / cosine(angle)});
    }
    points.push_back(points.back() + Vec2{10.0f, 0.0f});
    points.push_back(points.back() + Vec2{10.0f, 0.0f});
    EXPECT_TRUE(createChain(course.world, course.body(BodyKind::Static, {}), points, false).ok());
    return static_cast<double>(points.back().x) - 12.0;
}

TEST(Character, standsOnAFloorWithItsGap) {
    for (const Figure figure : kFigures) {
        SCOPED_TRACE(static_cast<int>(figure));
        Course course;
        const BodyId floor = course.wall({0.0, 1.0}, {50.0f, 1.0f});
        CharacterController one = course.character(definitionOf(figure), {0.0, -3.0});
        int landings = 0;
        for (int i = 0; i < 120; ++i) landings += course.tick(one).landed ? 1 : 0;
        EXPECT_EQ(landings, 1);
        ASSERT_TRUE(one.grounded());
        EXPECT_EQ(one.ground().body, floor);
        EXPECT_NEAR(one.ground().normal.y, -1.0f, 1.0e-6f);
        EXPECT_NEAR(one.position().y, -static_cast<double>(feetOf(one.definition().outline) + kGap), 2.0e-5);
        const WorldPosition rests = one.position();
        course.run(one, 1000);
        EXPECT_EQ(one.position(), rests);
    }
}

TEST(Character, fallsFreely) {
    Course course;
    CharacterController one = course.character({}, {3.0, 0.0});
    ASSERT_TRUE(one.setVelocity({2.0f, -5.0f}).ok());
    course.run(one, 120);
    EXPECT_NEAR(one.position().x, 3.0 + 2.0 * 2.0, 1.0e-5);
    EXPECT_NEAR(one.position().y, -5.0 * 2.0 + 0.5 * 10.0 * 4.0, 1.0e-4);
}

TEST(Character, staysOnTheGroundOverSlopesAndTheirJoints) {
    for (int run = 0; run < runsToTry(50); ++run) {
        SCOPED_TRACE(run);
        Random random = Random::seeded(static_cast<std::uint64_t>(run));
        Course course;
        const double end = addHills(course, random, 0.8726646f, 60);  // 0.873 rad is 50 degrees
        CharacterController one = course.character(definitionOf(kFigures[run % 4]), {-9.0, -1.5});
        course.run(one, 60);
        ASSERT_TRUE(one.grounded());
        const float speed = random.between(1.0f, 12.0f);
        float way = speed;
        for (int i = 0; i < 400; ++i) {
            const double x = one.position().x;
            if (x > end || x < -9.0) way = x > end ? -speed : speed;
            ASSERT_TRUE(walkOn(one, way));
            const CharacterMotion motion = course.tick(one);
            ASSERT_TRUE(one.grounded()) << i;
            ASSERT_FALSE(motion.wall || motion.leftGround || motion.landed) << i;
            ASSERT_NEAR(one.position().x - x, static_cast<double>(way * kTick), 1.1 * kGap) << i;
            ASSERT_LT(course.heightOver(one), 4.0f * kGap) << i;
        }
    }
}

TEST(Character, isGroundedForTenThousandFramesOfHills) {
    for (const Figure figure : kFigures) {
        SCOPED_TRACE(static_cast<int>(figure));
        Random random = Random::seeded(7);
        Course course;
        const double end = addHills(course, random, 0.8726646f, 200);
        CharacterController one = course.character(definitionOf(figure), {-9.0, -1.5});
        course.run(one, 60);
        float way = 6.0f;
        for (int i = 0; i < 10000; ++i) {
            if (one.position().x > end || one.position().x < -9.0)
                way = one.position().x > end ? -6.0f : 6.0f;
            ASSERT_TRUE(walkOn(one, way));
            course.tick(one);
            ASSERT_TRUE(one.grounded()) << i;
        }
    }
}

TEST(Character, slopesKeepTheHorizontalSpeedOrTheSpeedAlongTheGround) {
    for (const bool even : {true, false}) {
        Course course;
        const BodyId ramp = course.body(BodyKind::Static, {}, 0.5f);
        ASSERT_TRUE(createShape(course.world, ramp, box({100.0f, 1.0f})).ok());
        CharacterDefinition definition;
        definition.evenSpeed = even;
        CharacterController one = course.character(definition, {0.0, -2.5});
        course.run(one, 60);
        const WorldPosition before = one.position();
        course.walk(one, 3.0f, 60);
        const Vec2 way = one.position() - before;
        EXPECT_NEAR(even ? way.x : length(way), 3.0f, 1.0e-3f);
        EXPECT_NEAR(way.y / way.x, std::tan(0.5f), 1.0e-3f);
    }
}

TEST(Character, slidesDownTooSteepSlopesAndCannotWalkUpThem) {
    for (const Figure figure : kFigures) {
        SCOPED_TRACE(static_cast<int>(figure));
        Course course;
        const float angle = 1.1f;  // rad: 63 degrees
        const BodyId ramp = course.body(BodyKind::Static, {}, -angle);
        ASSERT_TRUE(createShape(course.world, ramp, box({100.0f, 1.0f})).ok());
        CharacterController one = course.character(definitionOf(figure), {0.0, -4.0});
        bool slid = false;
        for (int i = 0; i < 90; ++i) {
            const CharacterMotion motion = course.tick(one);
            EXPECT_FALSE(one.grounded());
            slid = slid || motion.slope;
        }
        EXPECT_TRUE(slid);
        const Vec2 down{-std::cos(angle), std::sin(angle)};
        const Vec2 before = one.velocity();
        course.run(one, 30);
        // Steep slopes have no friction: expects the acceleration g sin(angle), for half a second.
        EXPECT_NEAR(dot(one.velocity() - before, down), 10.0f * std::sin(angle) * 0.5f, 0.05f);
        EXPECT_NEAR(dot(one.velocity(), {std::sin(angle), std::cos(angle)}), 0.0f, 10.0f * kTick);
    }
}

TEST(Character, standsInAPitBetweenTwoSteepSlopes) {
    for (const Figure figure : kFigures) {
        SCOPED_TRACE(static_cast<int>(figure));
        Course course;
        const std::vector<Vec2> points{
            {-20.0f, -30.0f}, {-10.0f, -20.0f}, {0.0f, 0.0f}, {10.0f, -20.0f}, {20.0f, -30.0f}};
        ASSERT_TRUE(createChain(course.world, course.body(BodyKind::Static, {}), points, false).ok());
        CharacterController one = course.character(definitionOf(figure), {0.5, -6.0});
        course.run(one, 300);
        for (int i = 0; i < 300; ++i) {
            course.tick(one);
            ASSERT_TRUE(one.grounded()) << i;
        }
        EXPECT_NEAR(one.position().x, 0.0, 0.01);
    }
}

TEST(Character, wallsAndCeilingsAreReportedWithTheirNormals) {
    for (const Figure figure : kFigures) {
        SCOPED_TRACE(static_cast<int>(figure));
        Course course;
        course.wall({0.0, 1.0}, {50.0f, 1.0f});
        const BodyId wall = course.wall({5.0, -5.0}, {1.0f, 8.0f});
        const BodyId lid = course.wall({0.0, -4.0}, {3.0f, 0.5f});
        CharacterController one = course.character(definitionOf(figure), {0.0, -1.5});
        course.run(one, 60);
        ASSERT_TRUE(one.jump(9.0f).ok());
        CharacterMotion motion;
        for (int i = 0; i < 60 && !motion.ceiling; ++i) motion = course.tick(one);
        EXPECT_EQ(motion.ceiling.body, lid);
        EXPECT_NEAR(motion.ceiling.normal.y, 1.0f, 1.0e-5f);
        EXPECT_GE(one.velocity().y, 0.0f);
        course.run(one, 60);
        motion = course.walk(one, 4.0f, 120);
        EXPECT_EQ(motion.wall.body, wall);
        EXPECT_NEAR(motion.wall.normal.x, -1.0f, 1.0e-5f);
        EXPECT_EQ(one.velocity().x, 0.0f);
        EXPECT_TRUE(one.grounded());
        const float half = boundsOf(one.definition().outline, {}, {}).max.x;
        EXPECT_NEAR(one.position().x, 4.0 - static_cast<double>(half + kGap), 5.0e-5);
    }
}

TEST(Character, walksUpStepsUpToItsStepHeight) {
    for (const Figure figure : {Figure::Box, Figure::RoundedBox, Figure::Capsule}) {
        for (const float speed : {0.3f, 2.0f, 8.0f}) {
            for (const float over : {-0.25f, -0.1f, 0.0f, 0.002f, 0.05f}) {
                SCOPED_TRACE(std::to_string(static_cast<int>(figure)) + " " + std::to_string(speed) + " " +
                             std::to_string(over));
                Course course;
                const float height = 0.3f + over;
                course.wall({0.0, 1.0}, {50.0f, 1.0f});
                course.wall({12.0, 5.0 - static_cast<double>(height)}, {10.0f, 5.0f});
                CharacterDefinition definition = definitionOf(figure);
                definition.stepHeight = 0.3f;
                CharacterController one = course.character(definition, {1.2, -1.5});
                course.run(one, 60);
                const double floor = one.position().y;
                for (int i = 0; i < 480 && one.position().x < 18.0; ++i) {
                    ASSERT_TRUE(walkOn(one, speed));
                    course.tick(one);
                    ASSERT_TRUE(one.grounded()) << i;
                }
                const double climbed = floor - one.position().y;
                EXPECT_NEAR(climbed, over > 0.0f ? 0.0 : static_cast<double>(height), 1.0e-4);
                // Walks down again.
                for (int i = 0; i < 1000 && (one.position().x > 1.0 || !one.grounded()); ++i) {
                    ASSERT_TRUE(walkOn(one, -speed));
                    course.tick(one);
                }
                EXPECT_NEAR(one.position().y, floor, 1.0e-4);
            }
        }
    }
}

TEST(Character, followsStairsDownUpToItsSnapDistance) {
    for (const float height : {0.1f, 0.2f}) {
        Course course;
        for (int i = 0; i < 20; ++i) {
            course.wall({static_cast<double>(i), 10.0 + static_cast<double>(height) * i}, {0.5f, 10.0f});
        }
        CharacterDefinition definition;
        definition.snap = 0.15f;
        CharacterController one = course.character(definition, {0.0, -1.5});
        course.run(one, 60);
        int left = 0;
        for (int i = 0; i < 240; ++i) {
            ASSERT_TRUE(walkOn(one, 4.0f));
            left += course.tick(one).leftGround ? 1 : 0;
        }
        EXPECT_EQ(left > 0, height > 0.15f);
    }
}

TEST(Character, seamsOfAFloorOfBoxesDoNotDisturbIt) {
    for (int run = 0; run < runsToTry(50); ++run) {
        SCOPED_TRACE(run);
        Random random = Random::seeded(static_cast<std::uint64_t>(run));
        Course course;
        const double far = run % 5 == 4 ? 1048576.0 : 0.0;
        for (int i = 0; i < 40; ++i) {
            course.wall({far + i, far + 0.5 + static_cast<double>(random.between(0.0f, 0.0005f))},
                        {0.5f, 0.5f});
        }
        CharacterController one = course.character(definitionOf(kFigures[run % 4]), {far + 2.0, far - 1.5});
        course.run(one, 60);
        const double floor = one.position().y;
        const float speed = random.between(1.0f, 15.0f);
        for (int i = 0; one.position().x < far + 36.0; ++i) {
            const double x = one.position().x;
            ASSERT_TRUE(walkOn(one, speed));
            const CharacterMotion motion = course.tick(one);
            ASSERT_TRUE(one.grounded() && !motion.wall) << i;
            ASSERT_NEAR(one.position().x - x, static_cast<double>(speed * kTick), 1.1 * kGap);
            ASSERT_NEAR(one.position().y, floor, 2.0 * kGap);
        }
    }
}

TEST(Character, seamsOfTerrainTilesDoNotDisturbIt) {
    for (int run = 0; run < runsToTry(40); ++run) {
        SCOPED_TRACE(run);
        Random random = Random::seeded(static_cast<std::uint64_t>(run));
        Course course;
        TileMask mask{120, 40};
        int row = 20;
        for (int x = 0; x < 120; ++x) {
            const bool level = x < 4 || x > 115;
            const std::uint32_t wish = level ? 2 : random.below(4);
            const std::uint32_t kind = (wish == 0 && row > 35) || (wish == 1 && row < 3) ? 2 : wish;
            if (kind == 1) --row;
            const TileForm form = kind == 0   ? TileForm::SlopeDown
                                  : kind == 1 ? TileForm::SlopeUp
                                              : TileForm::Full;
            for (int y = row; y < 40; ++y) mask.set(x, y, {y == row ? form : TileForm::Full});
            if (kind == 0) ++row;
        }
        TerrainOutlines terrain{std::move(mask), 8};
        const auto changed = terrain.update();
        TerrainBody ground = *TerrainBody::create(course.world, terrain, {.cellSize = {1.0f, 1.0f}});
        ASSERT_TRUE(ground.update(course.world, terrain, changed).ok());
        CharacterController one = course.character(definitionOf(kFigures[run % 4]), {1.5, 18.0});
        course.run(one, 90);
        ASSERT_TRUE(one.grounded());
        const float speed = random.between(1.0f, 12.0f);
        for (int i = 0; i < 2000 && one.position().x < 117.0; ++i) {
            const double x = one.position().x;
            ASSERT_TRUE(walkOn(one, speed));
            const CharacterMotion motion = course.tick(one);
            ASSERT_TRUE(one.grounded()) << i;
            ASSERT_FALSE(motion.wall) << i;
            ASSERT_NEAR(one.position().x - x, static_cast<double>(speed * kTick), 1.1 * kGap) << i;
            ASSERT_LT(course.heightOver(one), 4.0f * kGap) << i;
        }
    }
}

}  // namespace
}  // namespace plumb::physics
