#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/model/bodies.hpp"
#include "physics/model/shapes.hpp"
#include "tests/physics/support/character_course.hpp"

namespace plumb::physics {
namespace {

constexpr float kThin = 0.125f;  // half of the platform's thickness, m
// Within this distance of a platform's end it is undefined whether a character stands on it.
constexpr float kEdge = 0.05f;  // m

/// A one-way platform whose velocity changes at random times.
struct Shelf {
    BodyId body;
    float half = 2.0f;
    Vec2 axis;            // direction of its motion, or {0, 0}
    float most = 0.0f;    // maximum speed, m/s
    float swing = 0.0f;   // maximum angular speed, rad/s
    bool steady = false;  // true: the velocity never changes
    int ticks = 0;
    Vec2 velocity;

    void drive(World& world, Random& random) {
        if (axis != Vec2{} && (ticks == 0 || (!steady && random.below(20) == 0))) {
            velocity =
                axis * (ticks == 0 || random.below(2) == 0 ? most * random.unit() : -most * random.unit());
        }
        EXPECT_TRUE(setVelocity(world, body, velocity).ok());
        if (swing > 0.0f) {
            const float now = static_cast<float>(ticks) * kTick;
            EXPECT_TRUE(setAngularVelocity(world, body, swing * cosine(2.0f * now)).ok());
        }
        ++ticks;
    }
};

/// Position of a character's feet in the frame of a platform, m: along the platform's top, and above it.
struct LocalFeet {
    float along = 0.0f;
    float over = 0.0f;

    static LocalFeet from(const World& world, const Shelf& shelf, const CharacterController& one) {
        const BodyPose& pose = world.bodies.pose[shelf.body.index];
        const Convex outline = convexOf(one.definition().outline, {});
        const Vec2 down = rotate(pose.rotation, {0.0f, 1.0f});
        const auto corner = static_cast<std::size_t>(farthest(outline.corners(), down));
        const Vec2 foot = outline.corners()[corner].point + down * outline.radius;
        const Vec2 arm = unrotate(pose.rotation, (one.position() - pose.centre) + foot);
        return {arm.x, -arm.y - kThin};
    }
    [[nodiscard]] bool isOn(const Shelf& shelf) const { return std::fabs(along) < shelf.half - kEdge; }
};

/// A platform with characters; tick() returns false if a character falls through.
struct OneWayCourse {
    Course course;
    Random random;
    Figure figure;
    Shelf shelf;
    std::vector<CharacterController> all;
    bool dropped = false;

    explicit OneWayCourse(int run)
        : random{Random::seeded(static_cast<std::uint64_t>(run) * 77 + 5)}, figure{kFigures[run % 4]} {
        shelf.half = random.between(1.5f, 3.0f);
    }
    void addShelf(WorldPosition top, float angle = 0.0f) {
        shelf.body = course.body(BodyKind::Kinematic, {top.x, top.y + static_cast<double>(kThin)}, angle);
        const ShapeDefinition oneWay{.oneWay = true};
        EXPECT_TRUE(createShape(course.world, shelf.body, box({shelf.half, kThin}), oneWay).ok());
    }
    CharacterController& add(WorldPosition position, Vec2 velocity = {}) {
        all.push_back(course.character(definitionOf(figure), position));
        EXPECT_TRUE(all.back().setVelocity(velocity).ok());
        return all.back();
    }
    /// Adds a character whose feet are at the position `feet`.
    CharacterController& addOn(WorldPosition feet, Vec2 velocity = {}) {
        const float height = feetOf(outlineOf(figure)) + kGap;
        return add({feet.x, feet.y - static_cast<double>(height)}, velocity);
    }
    [[nodiscard]] bool tick() {
        shelf.drive(course.world, random);
        std::vector<LocalFeet> before;
        for (const auto& one : all) before.push_back(LocalFeet::from(course.world, shelf, one));
        for (auto& one : all) one.update(course.world, kTick);
        step(course.world, kTick);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const LocalFeet after = LocalFeet::from(course.world, shelf, all[i]);
            const bool over = before[i].isOn(shelf) && after.isOn(shelf) && before[i].over >= 0.0f;
            if (over && after.over < -kGap && !dropped) return false;
        }
        return true;
    }
    [[nodiscard]] bool stands(std::size_t i) const { return all[i].ground().body == shelf.body; }
};

constexpr Vec2 kAxes[] = {
    {0.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}, {1.0f, 0.0f}, {0.70710678f, -0.70710678f}};
constexpr const char* kWays[] = {"still", "up", "down", "side", "diagonal"};

void moveShelf(OneWayCourse& run, int way) {
    run.shelf.axis = kAxes[way];
    run.shelf.most = 20.0f;
}

constexpr int kUsual = 80;

TEST(CharacterOneWay, landingCharactersNeverFallThroughMovingPlatforms) {
    for (int way = 0; way < 5; ++way) {
        int landed = 0;
        for (int i = 0; i < runsToTry(kUsual); ++i) {
            SCOPED_TRACE(std::string{kWays[way]} + " " + std::to_string(i));
            OneWayCourse run{i};
            moveShelf(run, way);
            run.addShelf({0.0, 0.0});
            const float x = run.random.between(-1.2f, 1.2f), height = run.random.between(0.01f, 2.0f);
            run.addOn(Vec2{x, -height}, {run.random.between(-4.0f, 4.0f), run.random.between(-5.0f, 20.0f)});
            bool stood = false;
            for (int t = 0; t < 90; ++t) {
                ASSERT_TRUE(run.tick()) << t;
                stood = stood || run.stands(0);
            }
            landed += stood ? 1 : 0;
        }
        EXPECT_GT(landed, runsToTry(kUsual) / 4) << kWays[way];
    }
}

TEST(CharacterOneWay, charactersStayOnMovingPlatforms) {
    for (int way = 1; way < 5; ++way) {
        for (int i = 0; i < runsToTry(kUsual); ++i) {
            SCOPED_TRACE(std::string{kWays[way]} + " " + std::to_string(i));
            OneWayCourse run{i};
            run.addShelf({0.0, 0.0});
            run.addOn(Vec2{run.random.between(-1.2f, 1.2f), 0.0f});
            for (int t = 0; t < 5; ++t) ASSERT_TRUE(run.tick());
            moveShelf(run, way);
            run.shelf.ticks = 0;
            for (int t = 0; t < 90; ++t) {
                ASSERT_TRUE(run.tick()) << t;
                ASSERT_TRUE(run.stands(0)) << t;
            }
        }
    }
}

TEST(CharacterOneWay, twoRidersWalkOnOnePlatform) {
    for (int i = 0; i < runsToTry(kUsual); ++i) {
        SCOPED_TRACE(i);
        OneWayCourse run{i};
        run.addShelf({0.0, 0.0});
        run.addOn({-0.7, 0.0}), run.addOn({0.7, 0.0});
        for (int t = 0; t < 5; ++t) ASSERT_TRUE(run.tick());
        moveShelf(run, 1 + i % 4);
        run.shelf.ticks = 0;
        float ways[] = {run.random.between(1.0f, 8.0f), -run.random.between(1.0f, 8.0f)};
        for (int t = 0; t < 90; ++t) {
            for (std::size_t k = 0; k < 2; ++k) {
                const float along = LocalFeet::from(run.course.world, run.shelf, run.all[k]).along;
                if (std::fabs(along) > 1.0f)
                    ways[k] = along > 0.0f ? -std::fabs(ways[k]) : std::fabs(ways[k]);
                ASSERT_TRUE(walkOn(run.all[k], ways[k]));
            }
            ASSERT_TRUE(run.tick()) << t;
            ASSERT_TRUE(run.stands(0) && run.stands(1)) << t;
        }
    }
}

TEST(CharacterOneWay, dropsFromOneOfAStackToTheNext) {
    for (int i = 0; i < runsToTry(kUsual); ++i) {
        SCOPED_TRACE(i);
        OneWayCourse run{i};
        const float apart = run.random.between(0.3f, 2.5f);
        BodyId shelves[4];
        for (int k = 0; k < 4; ++k) {
            shelves[k] = run.course.shelf(BodyKind::Kinematic, {0.0, static_cast<double>(apart) * k});
            ASSERT_TRUE(setVelocity(run.course.world, shelves[k], Vec2{0.0f, run.random.unit()} * 0.0f).ok());
        }
        CharacterController& one = run.addOn({0.0, -0.2});
        for (int k = 0; k < 4; ++k) {
            for (int t = 0; t < 90 && !one.grounded(); ++t) run.course.tick(one);
            ASSERT_EQ(one.ground().body, shelves[k]);
            run.course.run(one, 3);
            ASSERT_TRUE(one.dropThrough(run.course.world));
            ASSERT_FALSE(one.grounded());
        }
        for (int t = 0; t < 30; ++t) run.course.tick(one);
        EXPECT_FALSE(one.grounded());
    }
}

TEST(CharacterOneWay, rotatedAndSwingingPlatformsHoldCharacters) {
    int stood = 0;
    for (int i = 0; i < runsToTry(2 * kUsual); ++i) {
        SCOPED_TRACE(i);
        OneWayCourse run{i};
        const bool swings = i % 2 == 1;
        if (swings)
            moveShelf(run, i / 2 % 5), run.shelf.most = 5.0f,
                                       run.shelf.swing = run.random.between(0.1f, 1.0f);
        run.addShelf({0.0, 0.0}, swings ? 0.0f : run.random.between(-0.7f, 0.7f));
        run.addOn(Vec2{run.random.between(-0.5f, 0.5f), -run.random.between(1.5f, 3.0f)},
                  {run.random.between(-2.0f, 2.0f), 0.0f});
        for (int t = 0; t < 120; ++t) {
            ASSERT_TRUE(run.tick()) << t;
            stood += t == 119 && run.stands(0) ? 1 : 0;
        }
    }
    EXPECT_GT(stood, runsToTry(2 * kUsual) / 4);
}

TEST(CharacterOneWay, dropsThroughAPlatformThatMovesEvenly) {
    for (int way = 0; way < 5; ++way) {
        for (int i = 0; i < runsToTry(kUsual); ++i) {
            SCOPED_TRACE(std::string{kWays[way]} + " " + std::to_string(i));
            OneWayCourse run{i};
            run.addShelf({0.0, 0.0});
            run.addOn({0.0, 0.0});
            for (int t = 0; t < 5; ++t) ASSERT_TRUE(run.tick());
            moveShelf(run, way);
            run.shelf.ticks = 0, run.shelf.steady = true;
            for (int t = 0; t < 20; ++t) ASSERT_TRUE(run.tick());
            ASSERT_TRUE(run.stands(0));
            ASSERT_TRUE(run.all[0].dropThrough(run.course.world));
            run.dropped = true;
            for (int t = 1; t <= 40; ++t) {
                ASSERT_TRUE(run.tick());
                ASSERT_FALSE(run.all[0].grounded()) << t;
                // The character starts with the velocity of the platform and falls freely.
                const float fallen = 5.0f * static_cast<float>(t * t) * kTick * kTick;
                ASSERT_NEAR(LocalFeet::from(run.course.world, run.shelf, run.all[0]).over, -fallen,
                            3.0f * kGap)
                    << t;
            }
        }
    }
}

/// Runs a character next to the platform and an equal one in a world without a platform: both must move
/// equally until the first one reaches the top of the platform.
void flyAsIfAlone(OneWayCourse& run, Course& empty, int ticks) {
    CharacterController twin = run.all[0];
    for (int t = 0; t < ticks; ++t) {
        const LocalFeet before = LocalFeet::from(run.course.world, run.shelf, run.all[0]);
        ASSERT_TRUE(run.tick()) << t;
        empty.tick(twin);
        if (run.stands(0) || run.all[0].position() != twin.position()) {
            ASSERT_GE(before.over, -1.0e-4f) << t;  // it may land only from above
            return;
        }
        ASSERT_EQ(run.all[0].velocity(), twin.velocity()) << t;
    }
}

TEST(CharacterOneWay, aCharacterThatStartsInsideFallsThrough) {
    for (int way = 0; way < 5; ++way) {
        if (way == 2) continue;  // a platform that moves down is soon below the character
        for (int i = 0; i < runsToTry(kUsual); ++i) {
            SCOPED_TRACE(std::string{kWays[way]} + " " + std::to_string(i));
            OneWayCourse run{i};
            Course empty;
            moveShelf(run, way);
            run.shelf.steady = true;
            run.addShelf({0.0, 0.0});
            const float height = 2.0f * feetOf(outlineOf(run.figure)) + 0.2f;
            run.addOn(Vec2{run.random.between(-1.0f, 1.0f), run.random.between(0.01f, height)},
                      {run.random.between(-4.0f, 4.0f), 0.0f});
            flyAsIfAlone(run, empty, 40);
            ASSERT_FALSE(run.stands(0));
        }
    }
}

TEST(CharacterOneWay, aCharacterFromBelowPassesThrough) {
    for (int way = 0; way < 5; ++way) {
        int landed = 0;
        for (int i = 0; i < runsToTry(kUsual); ++i) {
            SCOPED_TRACE(std::string{kWays[way]} + " " + std::to_string(i));
            OneWayCourse run{i};
            Course empty;
            moveShelf(run, way);
            run.shelf.most = 4.0f;
            run.addShelf({0.0, 0.0});
            const float below = 2.0f * feetOf(outlineOf(run.figure)) + run.random.between(0.3f, 1.5f);
            run.addOn(Vec2{run.random.between(-2.5f, 2.5f), below},
                      {run.random.between(-6.0f, 6.0f), -run.random.between(6.0f, 14.0f)});
            flyAsIfAlone(run, empty, 150);
            landed += run.stands(0) ? 1 : 0;
        }
        EXPECT_GT(landed, runsToTry(kUsual) / 20) << kWays[way];
    }
}

TEST(CharacterOneWay, itsSidesStopNoCharacter) {
    for (int i = 0; i < runsToTry(2 * kUsual); ++i) {
        SCOPED_TRACE(i);
        OneWayCourse run{i};
        Course empty;
        for (Course* course : {&run.course, &empty}) course->wall({0.0, 1.0}, {100.0f, 1.0f});
        const bool moves = i % 2 == 1;
        if (moves) moveShelf(run, 3), run.shelf.most = 10.0f;
        run.addShelf({6.0, -static_cast<double>(run.random.between(0.02f, 2.2f))});
        const float speed = run.random.between(0.5f, 12.0f);
        CharacterController& one = run.addOn({0.0, 0.0});
        CharacterController twin = one;
        for (int t = 0; t < 90; ++t) {
            ASSERT_TRUE(walkOn(one, speed) && walkOn(twin, speed));
            ASSERT_TRUE(run.tick()) << t;
            empty.tick(twin);
            ASSERT_EQ(one.position(), twin.position()) << t;
        }
    }
}

}  // namespace
}  // namespace plumb::physics
