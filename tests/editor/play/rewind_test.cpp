#include <cstdlib>
#include <vector>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)  // other allocators have no mallinfo2()
#include <malloc.h>
#endif

#include "core/clock.hpp"
#include "core/random.hpp"
#include "editor/model/play/play_mode.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/editor/support/played_games.hpp"

namespace plumb::editor {
namespace {

using Make = std::unique_ptr<PlaySession> (*)();

/// A recorded game, with the hashes of the same game without recording.
struct Played {
    PlayMode play;
    std::vector<std::uint64_t> hashes;  // indexed by tick
    std::size_t contacts = 0;
    std::size_t inputs = 0;

    Played(Make make, int ticks) {
        const std::unique_ptr<PlaySession> straight = make();
        hashes.push_back(straight->world().hash());
        for (int tick = 0; tick < ticks; ++tick) {
            straight->tick(runAndJump(tick));
            hashes.push_back(straight->world().hash());
            contacts += straight->world().resource<PhysicsState>().world.contacts.size();
            inputs += runAndJump(tick) == InputFrame{} ? 0 : 1;
        }
        play.start(make());
        for (int tick = 0; tick < ticks; ++tick) play.step(runAndJump(tick));
    }
    [[nodiscard]] std::uint64_t hash() const { return play.world().hash(); }
    [[nodiscard]] std::uint64_t expected() const { return hashes[static_cast<std::size_t>(play.ticks())]; }
};

void expectTheExactPast(Make make) {
    Played game{make, 2100};
    ASSERT_EQ(game.hash(), game.expected()) << "recording changes nothing";
    EXPECT_GT(game.contacts, 1000u);
    EXPECT_GT(game.inputs, 1000u);
    EXPECT_EQ(game.play.newest(), 2100);
    EXPECT_EQ(game.play.oldest(), 300) << "30 s";
    Random random = Random::seeded(7);
    for (int i = 0; i < 100; ++i) {
        const std::int64_t tick = 300 + random.below(1801);
        game.play.seek(tick);
        ASSERT_EQ(game.play.ticks(), tick);
        ASSERT_EQ(game.hash(), game.expected()) << "tick " << tick;
    }
    EXPECT_EQ(game.play.newest(), 2100) << "looking back forgets nothing";
}

TEST(Rewind, everyTickOfThirtySecondsOfThePlatformerIsRestoredExactly) {
    expectTheExactPast([] { return platformerSession(); });
}

TEST(Rewind, everyTickOfThirtySecondsOfFiveHundredBodiesIsRestoredExactly) {
    expectTheExactPast(&playgroundSession);
}

TEST(Rewind, steppingReplaysRecordedTicks) {
    Played game{[] { return platformerSession(); }, 200};
    for (int i = 0; i < 40; ++i) {
        game.play.seek(game.play.ticks() - 1);
        ASSERT_EQ(game.hash(), game.expected()) << game.play.ticks();
    }
    EXPECT_EQ(game.play.ticks(), 160);
    for (int i = 0; i < 20; ++i) {
        game.play.step(InputFrame{});  // live input must not affect replayed ticks
        ASSERT_EQ(game.hash(), game.expected()) << game.play.ticks();
    }
    EXPECT_EQ(game.play.ticks(), 180);
    game.play.seek(-5);
    EXPECT_EQ(game.play.ticks(), 0);
    EXPECT_EQ(game.hash(), game.expected());
    game.play.seek(100'000);
    EXPECT_EQ(game.play.ticks(), 200);
    EXPECT_EQ(game.hash(), game.expected());
}

TEST(Rewind, continuingFromThePastDiscardsTheLaterTicks) {
    Played game{[] { return platformerSession(); }, 300};
    game.play.seek(120);
    EXPECT_TRUE(game.play.paused());
    EXPECT_TRUE(game.play.inPast());
    game.play.setPaused(false);
    EXPECT_FALSE(game.play.inPast());
    EXPECT_EQ(game.play.newest(), 120);
    for (int tick = 120; tick < 300; ++tick) game.play.step(runAndJump(tick));
    EXPECT_EQ(game.hash(), game.expected()) << "the same hands come to the same";
    game.play.seek(120);
    game.play.setPaused(false);
    for (int tick = 120; tick < 300; ++tick) game.play.step(InputFrame{});
    EXPECT_NE(game.hash(), game.expected()) << "others do not";
    game.play.seek(90);
    EXPECT_EQ(game.hash(), game.expected());
}

TEST(Rewind, aRecordingCanBeWatchedAndStopsAtItsEnd) {
    Played game{[] { return platformerSession(); }, 300};
    game.play.seek(200);
    game.play.playReplay();
    EXPECT_TRUE(game.play.isReplaying());
    for (int i = 0; i < 200; ++i) static_cast<void>(game.play.advance(1.0 / 60.0, InputFrame{}));
    EXPECT_TRUE(game.play.paused());
    EXPECT_EQ(game.play.ticks(), 300);
    EXPECT_EQ(game.hash(), game.expected());
}

/// Returns a falling entity of the scene.
ObjectId someBody(World& world) {
    ObjectId found;
    world.each<const SceneEntity, const RigidBody>([&](const SceneEntity& part, const RigidBody&) {
        if (!found) found = {part.id};
    });
    return found;
}

TEST(Rewind, editsDuringTheGameAreReplayed) {
    PlayMode play;
    play.start(playgroundSession());
    const TypeInfo& type = play.world().types()->of<RigidBody>();
    const FieldInfo& field = *type.find("velocity");
    std::vector<std::uint64_t> hashes{play.world().hash()};
    const ObjectId body = someBody(play.world());
    ASSERT_TRUE(body);
    for (int tick = 0; tick < 200; ++tick) {
        if (tick == 33 || tick == 34 || tick == 90) {
            const Vec2 velocity{static_cast<float>(tick), -400.0f};
            play.edit(body, type, field, FieldValue::of(velocity));
            hashes.back() = play.world().hash();
        }
        play.step({});
        hashes.push_back(play.world().hash());
    }
    for (const std::int64_t tick : {0, 33, 32, 34, 35, 90, 89, 120, 200, 91}) {
        play.seek(tick);
        ASSERT_EQ(play.world().hash(), hashes[static_cast<std::size_t>(tick)]) << "tick " << tick;
    }
    // A change made in the past discards the later ticks.
    play.seek(60);
    play.edit(body, type, field, FieldValue::of(Vec2{0.0f, -900.0f}));
    EXPECT_EQ(play.newest(), 60);
    EXPECT_EQ(play.edits().log().size(), 3u) << "the one of tick 90 did not happen";
    EXPECT_EQ(play.edits().last().size(), 1u);
    for (int i = 0; i < 140; ++i) play.step({});
    EXPECT_NE(play.world().hash(), hashes.back());
}

TEST(Rewind, snapshotsStayBelowTheirLimit) {
    PlayMode play;
    play.start(makeGameSession(playgroundProject(), "scenes/pyramid.scene.json", heapScene(500)));
    std::size_t most = 0;
    for (int tick = 0; tick < 2000; ++tick) {
        play.step({});
        most = std::max(most, play.recording().bytes());
    }
    EXPECT_LE(most, PlayRecording::kBytes);
    EXPECT_GT(most, std::size_t{1} << 20);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)  // other allocators have no mallinfo2()
/// Heap memory of a recording of 30 s, MB.
double megabytesOf(Make make) {
    const auto used = [] {
        const struct mallinfo2 info = mallinfo2();
        return info.uordblks + info.hblkhd;
    };
    PlayMode play;
    play.start(make());
    for (int tick = 0; tick < 60; ++tick) play.step(runAndJump(tick));
    const std::size_t before = used();
    for (int tick = 60; tick < 1900; ++tick) play.step(runAndJump(tick));
    return static_cast<double>(used() - before) / 1e6;
}

TEST(Rewind, thirtySecondsStayBelowTheMemoryLimit) {
    const double platformer = megabytesOf([] { return platformerSession(); });
    const double playground = megabytesOf(&playgroundSession);
    RecordProperty("platformerMegabytes", std::to_string(platformer));
    RecordProperty("playgroundMegabytes", std::to_string(playground));
    std::printf("30 s of the platformer: %.1f MB, of 500 bodies: %.1f MB\n", platformer, playground);
    EXPECT_LE(platformer, 256.0);
    EXPECT_LE(playground, 256.0);
    EXPECT_GT(playground, 1.0);
}
#endif

TEST(TimeControl, theSpeedScalesTheTicksPerSecond) {
    for (int speed = PlayMode::kSlowest; speed <= PlayMode::kFastest; ++speed) {
        SCOPED_TRACE(speed);
        PlayMode play;
        play.setSpeed(speed);
        play.start(platformerSession());
        for (int frame = 0; frame < 64; ++frame) static_cast<void>(play.advance(1.0 / 60.0, {}));
        EXPECT_NEAR(static_cast<double>(play.ticks()), 64.0 * std::exp2(speed), 1.0);
    }
}

TEST(TimeControl, aLongFrameSlowsTheGameDownInsteadOfFreezingTheEditor) {
    PlayMode play;
    play.setSpeed(PlayMode::kFastest);
    play.start(platformerSession());
    static_cast<void>(play.advance(10.0, {}));
    EXPECT_LE(play.ticks(), 33);
    EXPECT_GT(play.ticks(), 8);
}

TEST(TimeControl, theFirstTickComesWithinATenthOfASecond) {
    double least = 1e9;  // s of CPU time, which other processes do not disturb
    for (int i = 0; i < 3; ++i) {
        const double start = threadSeconds();
        PlayMode play;
        play.start(platformerSession("scenes/level4.scene.json"));
        play.step({});
        least = std::min(least, threadSeconds() - start);
    }
    std::printf("from play to the first tick: %.0f ms\n", least * 1000.0);
    EXPECT_LE(least, 0.1);
}

TEST(TimeControl, aGameStartedPausedDoesNotTickUntilResumed) {
    PlayMode play;
    play.start(platformerSession(), true);
    static_cast<void>(play.advance(1.0, {}));
    EXPECT_EQ(play.ticks(), 0);
    play.step({});
    EXPECT_EQ(play.ticks(), 1);
}

}  // namespace
}  // namespace plumb::editor
