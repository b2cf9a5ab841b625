#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "tests/gameplay/level.hpp"

namespace plumb {
namespace {

const std::vector<std::string_view> kFlat = {
    "                                        ", "                                        ",
    "                                        ", "                                        ",
    "                                        ", "                                        ",
    "                                        ", "                                        ",
    "########################################", "########################################",
};
constexpr float kFloor = 128.0f;

TEST(PlayerController, fallsToTheGroundAndStandsStill) {
    Level level{kFlat};
    level.addPlayer({100, 60});
    level.settle();
    ASSERT_TRUE(level.grounded());
    const Vec2 rest = level.at();
    EXPECT_NEAR(level.feet(), kFloor, 0.1f);
    for (int i = 0; i < 600; ++i) {
        level.tick();
        ASSERT_TRUE(level.grounded());
        ASSERT_EQ(level.at(), rest);
    }
}

TEST(PlayerController, runsToItsTopSpeedAndStops) {
    Level level{kFlat};
    level.addPlayer({50, kFloor});
    level.settle();
    level.hold(Key::Right);
    level.run(30);
    EXPECT_EQ(level.velocity().x, 180.0f);
    const float x = level.at().x;
    level.run(60);
    EXPECT_NEAR(level.at().x - x, 180.0f, 0.01f);
    level.hold(Key::Right, false);
    level.run(12);
    EXPECT_EQ(level.velocity().x, 0.0f);
}

/// Height of a jump whose key is held, px, computed tick by tick from the controller's constants.
float heldJumpHeight(const PlayerController& p) {
    float height = 0.0f;
    float speed = p.jumpSpeed;
    for (int i = 0; i < p.jumpHoldTicks; ++i) height += speed / 60.0f;
    while (speed > 0.0f) {
        speed -= p.gravity / 60.0f * (speed < p.apexSpeed ? 0.5f : 1.0f);
        if (speed > 0.0f) height += speed / 60.0f;
    }
    return height;
}

TEST(PlayerController, aHeldJumpReachesTheHeightOfItsConstants) {
    Level level{kFlat};
    level.addPlayer({100, kFloor});
    level.settle();
    level.hold(Key::Space);
    float highest = level.feet();
    const float start = level.feet();
    for (int i = 0; i < 90; ++i) {
        level.tick();
        highest = std::min(highest, level.feet());
    }
    EXPECT_NEAR(start - highest, heldJumpHeight(level.player.get<PlayerController>()), 0.5f);
    EXPECT_TRUE(level.grounded()) << "a held key must jump once";
}

TEST(PlayerController, releasingTheKeyEarlyJumpsLower) {
    float before = 0.0f;
    for (const int held : {1, 3, 6, 9, 12}) {
        Level level{kFlat};
        level.addPlayer({100, kFloor});
        level.settle();
        level.hold(Key::Space);
        const float start = level.feet();
        float highest = start;
        for (int i = 0; i < 60; ++i) {
            if (i == held) level.hold(Key::Space, false);
            level.tick();
            highest = std::min(highest, level.feet());
        }
        EXPECT_GT(start - highest, before) << held;
        before = start - highest;
    }
}

/// True if a press this many ticks after walking off an edge still jumps.
bool jumpsLate(int ticksAfterEdge) {
    Level level{{"                    ", "                    ", "                    ",
                 "########            ", "                    ", "                    ",
                 "                    ", "                    "}};
    level.addPlayer({100, 48});
    level.settle();
    level.hold(Key::Right);
    while (level.grounded()) level.tick();
    level.run(ticksAfterEdge);
    level.hold(Key::Space);
    level.tick();
    return level.velocity().y < 0.0f;
}

TEST(PlayerController, coyoteTimeIsSixTicks) {
    for (int late = 0; late < 10; ++late) EXPECT_EQ(jumpsLate(late), late < 6) << late;
}

/// True if a press this many ticks before landing jumps on landing.
bool jumpsOnLanding(int early) {
    int landing = 0;
    for (const bool measure : {true, false}) {
        Level level{kFlat};
        level.addPlayer({100, 60});
        for (int i = 0; i < 60; ++i) {
            if (!measure && i == landing - early) level.hold(Key::Space);
            level.tick();
            if (measure && level.grounded()) {
                landing = i;
                break;
            }
            if (!measure && i > landing && level.velocity().y < 0.0f) return true;
        }
    }
    return false;
}

TEST(PlayerController, aJumpPressIsBufferedForSixTicks) {
    for (int early = 1; early < 10; ++early) EXPECT_EQ(jumpsOnLanding(early), early <= 5) << early;
}

TEST(PlayerController, cornerCorrectionMovesTheHeadPastCorners) {
    for (const float miss : {1.0f, 3.0f, 4.0f, 6.0f, 9.0f}) {
        Level level{{"                    ", "                    ", "                    ",
                     "                    ", "     ##             ", "                    ",
                     "                    ", "                    ", "####################"}};
        level.addPlayer({112 + 6 - miss, kFloor});  // the block ends at x = 112
        level.settle();
        level.hold(Key::Space);
        float highest = level.feet();
        for (int i = 0; i < 40; ++i) {
            level.tick();
            highest = std::min(highest, level.feet());
        }
        EXPECT_EQ(highest < 90.0f, miss <= 4.0f) << miss;
    }
}

TEST(PlayerController, slopesKeepTheSpeedAndThePlayerGrounded) {
    const std::vector<std::string_view> hills = {
        "                                                  ",
        "          /\\        lh##HL                        ",
        "         /##\\     lh######HL                      ",
        "        /####\\  lh##########HL                    ",
        "##################################################",
    };
    for (const Key key : {Key::Right, Key::Left}) {
        Level level{hills};
        level.addPlayer({key == Key::Right ? 40.0f : 500.0f, 64});
        level.settle();
        level.hold(key);
        level.run(10);
        float x = level.at().x;
        float highest = level.feet();
        for (int i = 0; i < 120; ++i) {
            level.tick();
            ASSERT_TRUE(level.grounded()) << i << " at " << level.at().x << " " << level.feet();
            ASSERT_NEAR(std::abs(level.at().x - x), 3.0f, 0.02f) << i << " at " << x << " " << level.feet();
            x = level.at().x;
            highest = std::min(highest, level.feet());
        }
        EXPECT_NEAR(highest, 16.0f, 0.2f);
    }
}

TEST(PlayerController, aStandStillOnASlopeDoesNotSlide) {
    Level level{{"          ", "    /#    ", "   /##    ", "##########"}};
    level.addPlayer({64, 10});
    level.run(60);
    ASSERT_TRUE(level.grounded());
    const Vec2 rest = level.at();
    level.run(300);
    EXPECT_EQ(level.at(), rest);
}

TEST(PlayerController, oneWayGroundIsPassedUpwardsAndDroppedThrough) {
    Level level{
        {"          ", "          ", "          ", "  ----    ", "          ", "          ", "##########"}};
    level.addPlayer({64, 96});
    level.settle();
    level.hold(Key::Space);
    level.run(60);
    level.hold(Key::Space, false);
    level.run(30);
    EXPECT_NEAR(level.feet(), 48.0f, 0.1f) << "the player stands on the platform";
    level.hold(Key::Down);
    level.run(30);
    EXPECT_NEAR(level.feet(), 48.0f, 0.1f) << "Down without Jump does nothing";
    level.hold(Key::Space);
    level.run(40);
    EXPECT_NEAR(level.feet(), 96.0f, 0.1f);
}

TEST(PlayerController, aPlatformCarriesWithoutDrift) {
    for (const Vec2 way : {Vec2{120, 0}, Vec2{0, -90}, Vec2{80, 60}}) {
        Level level{{}};
        Entity platform = level.addBox({100, 200}, {48, 10});
        platform.addComponent<KinematicBody>();
        MovingPlatform& moving = platform.addComponent<MovingPlatform>();
        moving.way = way;
        moving.period = 3.0f;
        level.addPlayer({124, 199});
        level.run(5);
        ASSERT_TRUE(level.grounded());
        const Vec2 seat = level.at() - platform.get<Transform>().position;
        for (int i = 0; i < 3600; ++i) {
            level.tick();
            ASSERT_TRUE(level.grounded()) << i;
            const Vec2 drift = level.at() - platform.get<Transform>().position - seat;
            ASSERT_LT(std::abs(drift.x), 0.02f) << i;
            ASSERT_LT(std::abs(drift.y), 0.05f) << i;
        }
    }
}

TEST(PlayerController, aOneWayPlatformThatRisesPicksUpAndCarries) {
    Level level{{}};
    Entity platform = level.addBox({100, 200}, {48, 10});
    platform.get<BoxCollider>().oneWay = true;
    platform.addComponent<KinematicBody>();
    MovingPlatform& moving = platform.addComponent<MovingPlatform>();
    moving.way = {0, -150};
    moving.period = 2.0f;
    level.addPlayer({124, 150});
    level.run(40);
    for (int i = 0; i < 1200; ++i) {
        level.tick();
        ASSERT_TRUE(level.grounded()) << i;
        ASSERT_NEAR(level.feet(), platform.get<Transform>().position.y, 0.2f);
    }
}

TEST(PlayerController, aJumpKeepsThePlatformsSpeed) {
    Level level{{}};
    Entity platform = level.addBox({100, 200}, {480, 10});
    platform.addComponent<KinematicBody>();
    MovingPlatform& moving = platform.addComponent<MovingPlatform>();
    moving.way = {600, 0};
    moving.period = 10.0f;  // a speed of 120 px/s
    moving.easing = Easing::Linear;
    level.addPlayer({124, 199});
    level.run(20);
    ASSERT_TRUE(level.grounded());
    level.hold(Key::Space);
    level.tick();
    EXPECT_NEAR(level.velocity().x, 120.0f, 0.5f);
}

TEST(PlayerController, wallsStopItWithoutOverlap) {
    std::vector<std::string_view> rows(8, "          #");
    rows.back() = "###########";
    Level level{rows};
    level.addPlayer({100, 112});
    level.settle();
    level.hold(Key::Right);
    level.run(90);
    EXPECT_NEAR(level.at().x, 160.0f - 12.0f, 0.1f);
    EXPECT_TRUE(level.grounded());
    level.hold(Key::Space);
    level.run(20);
    EXPECT_NEAR(level.at().x, 160.0f - 12.0f, 0.1f);
}

TEST(PlayerController, pushesLooseBoxes) {
    Level level{kFlat};
    level.addPlayer({100, kFloor});
    Entity crate = level.addBox({140, kFloor - 16}, {16, 16});
    crate.addComponent<RigidBody>();
    level.settle();
    level.hold(Key::Right);
    level.run(120);
    EXPECT_GT(crate.get<Transform>().position.x, 200.0f);
    EXPECT_NEAR(crate.get<Transform>().position.y, kFloor - 16, 0.2f);
    EXPECT_LE(level.at().x + 12.0f, crate.get<Transform>().position.x + 0.5f);
}

TEST(PlayerController, randomInputNeverLeavesTheRoomAndRepeatsBitForBit) {
    const std::vector<std::string_view> room = {
        "##############################",  "#                            #",
        "#        ----      /##\\      #", "#                 /####\\     #",
        "#   ###     --   ########    #",  "#                            #",
        "#  /##\\   lh##HL      ---    #", "# /####\\lh######HL           #",
        "##############################",
    };
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        std::uint64_t hashes[2] = {};
        for (std::uint64_t& hash : hashes) {
            Level level{room};
            level.addPlayer({40, 60});
            Random random = Random::seeded(seed);
            for (int i = 0; i < 900; ++i) {
                if (i % 7 == 0) {
                    level.hold(Key::Left, random.below(3) == 0);
                    level.hold(Key::Right, random.below(2) == 0);
                    level.hold(Key::Down, random.below(4) == 0);
                    level.hold(Key::Space, random.below(2) == 0);
                }
                level.tick();
                ASSERT_GT(level.at().x, 15.9f) << i;
                ASSERT_LT(level.at().x, 29 * 16 - 11.9f) << i;
                ASSERT_GT(level.at().y, 15.9f) << i;
                ASSERT_LT(level.feet(), 8 * 16 + 0.1f) << i;
            }
            hash = level.world.hash();
        }
        EXPECT_EQ(hashes[0], hashes[1]);
    }
}

}  // namespace
}  // namespace plumb
