#include "input/packed_input.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/damage.hpp"

namespace plumb {
namespace {

/// Changes some words of a frame at random, by a little or to any value.
InputFrame changed(InputFrame frame, Random& random) {
    for (int i = 0; i < 3; ++i) {
        frame.pads[random.below(kPadCount)].axes[random.below(kPadAxisCount)] =
            static_cast<std::int16_t>(random.next());
        frame.mouseX = static_cast<std::int16_t>(frame.mouseX + static_cast<int>(random.below(5)) - 2);
        const auto key = static_cast<Key>(1 + random.below(kKeyCount - 1));
        frame.set(key, !frame.has(key));
    }
    return frame;
}

/// Unpacks all of it. @return an error message; empty: none
std::string unpacked(std::string_view packed, Replay& replay) {
    std::uint64_t ticks = 0;
    std::string problem = unpackInput(packed, replay, ticks);
    EXPECT_TRUE(!problem.empty() || ticks == replay.ticks());
    return problem;
}

/// The packed input as the report of a crash contains it.
std::string bytesOf(const PackedInput::Content& content) {
    return std::string{content.closed} + std::string{content.open.data(), content.openSize};
}

TEST(PackedInput, givesBackEveryFrameAtAnyTime) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Random random = Random::seeded(seed);
        PackedInput packed;
        Recorder recorder;
        InputFrame frame;
        for (int run = 0; run < 60; ++run) {
            const std::uint32_t ticks = 1 + random.below(random.below(8) == 0 ? 20000 : 3);
            for (std::uint32_t i = 0; i < ticks; ++i) packed.record(frame), recorder.record(frame);
            const PackedInput::Content content = packed.content();
            Replay replay;
            ASSERT_EQ(unpacked(bytesOf(content), replay), "");
            ASSERT_EQ(replay.runs, recorder.replay.runs) << "seed " << seed << ", run " << run;
            ASSERT_EQ(content.ticks, recorder.ticks());
            if (random.below(4) != 0) frame = changed(frame, random);
        }
    }
}

TEST(PackedInput, ofNothingIsEmpty) { EXPECT_EQ(bytesOf(PackedInput{}.content()), ""); }

TEST(PackedInput, takesFewBytesForAMouseThatNeverRests) {
    PackedInput packed;
    InputFrame frame;
    for (int i = 0; i < 1000; ++i) {
        frame.mouseX = static_cast<std::int16_t>(i % 300), frame.mouseY = static_cast<std::int16_t>(i % 200);
        packed.record(frame);
    }
    EXPECT_LE(bytesOf(packed.content()).size(), 5100u);
}

TEST(PackedInput, endsWithAWholeTickWhenItsMemoryIsFull) {
    PackedInput packed;
    InputFrame frame;
    std::uint64_t recorded = 0;
    while (!packed.full()) {
        ++recorded;
        for (PadFrame& pad : frame.pads) {
            for (std::int16_t& axis : pad.axes) axis = static_cast<std::int16_t>(axis ^ 0x7fff);
        }
        packed.record(frame);
    }
    packed.record({});
    const PackedInput::Content content = packed.content();
    EXPECT_EQ(content.ticks, recorded - 1);
    EXPECT_LE(content.closed.size() + content.openSize, PackedInput::kBytes);
    EXPECT_GT(content.closed.size(), PackedInput::kBytes - 2 * PackedInput::kLongestRun);
    Replay replay;
    ASSERT_EQ(unpacked(bytesOf(content), replay), "");
    EXPECT_EQ(replay.ticks(), recorded - 1);
}

TEST(PackedInput, holdsNoMoreChangesThanAReplay) {
    PackedInput packed;
    InputFrame frame;
    for (std::size_t i = 0; i < Replay::kMaxRuns + 5; ++i) {
        frame.keys[0] ^= 2u;
        packed.record(frame);
    }
    EXPECT_TRUE(packed.full());
    Replay replay;
    EXPECT_EQ(unpacked(bytesOf(packed.content()), replay), "");
}

TEST(PackedInput, holdsNoMoreTicksThanAReplay) {
    PackedInput packed;
    for (std::uint64_t i = 0; i < Replay::kMaxTicks; ++i) packed.record({});
    EXPECT_FALSE(packed.full());
    packed.record({});
    EXPECT_TRUE(packed.full());
    EXPECT_EQ(packed.content().ticks, Replay::kMaxTicks);
}

/// A report of a crash.
std::string reportOf(std::string_view packed, std::uint64_t ticks) {
    return "plumb-replay 2\nproject Sky\nengine 0.1.0\nscene \nseed 000000000000002a\nbuild 0a\n"
           "crash SIGSEGV, a wrong access\nrunning MoveSystem\ncheck 2 00000000000000aa\npacked " +
           std::to_string(packed.size()) + "\n" + std::string{packed} + "\nend " + std::to_string(ticks) +
           "\n\nback trace\n\xff not UTF-8\n";
}

class CrashReplay : public testing::Test {
protected:
    CrashReplay() {
        PackedInput input;
        InputFrame frame;
        for (int i = 0; i < 200; ++i) {
            if (i % 7 == 0) frame = changed(frame, random_);
            input.record(frame);
            recorder_.record(frame);
        }
        packed_ = bytesOf(input.content());
    }

    Random random_ = Random::seeded(7);
    Recorder recorder_;
    std::string packed_;
};

TEST_F(CrashReplay, isReadWithItsInputAndItsCrash) {
    const Result<Replay> replay = parseReplay(reportOf(packed_, 200), "crash.replay");
    ASSERT_TRUE(replay.ok()) << replay.error().text();
    EXPECT_EQ(replay->runs, recorder_.replay.runs);
    EXPECT_EQ(replay->crash, (RecordedCrash{"SIGSEGV, a wrong access", "MoveSystem", "0a"}));
    EXPECT_EQ(replay->seed, 42u);
    EXPECT_EQ(replay->checkpoints.size(), 1u);
}

TEST_F(CrashReplay, thatIsDamagedIsRefusedOrStillAReplay) {
    const std::string report = reportOf(packed_, 200);
    for (int i = 0; i < 3000; ++i) {
        const std::string damaged =
            i % 2 == 0 ? test::damaged(report, random_) : test::withWrongBytes(report, random_);
        const Result<Replay> replay = parseReplay(damaged, "crash.replay");
        if (replay) {
            EXPECT_LE(replay->ticks(), Replay::kMaxTicks);
        } else {
            EXPECT_FALSE(replay.error().what.empty());
            EXPECT_FALSE(replay.error().remedy.empty());
        }
    }
}

TEST_F(CrashReplay, sErrorsSayWhatIsWrong) {
    const auto errorOf = [](const std::string& text) {
        const Result<Replay> replay = parseReplay(text, "c.replay");
        return replay ? std::string{} : replay.error().text();
    };
    EXPECT_NE(errorOf(reportOf(packed_, 201)).find("expected 200, the number of ticks"), std::string::npos);
    EXPECT_NE(errorOf("plumb-replay 2\npacked 99\nabc\nend 0\n").find("the number of bytes that follow"),
              std::string::npos);
    EXPECT_NE(errorOf("plumb-replay 2\npacked 1\n\x7f\nend 0\n").find("no such change"), std::string::npos);
    EXPECT_NE(errorOf(std::string{"plumb-replay 2\npacked 1\n\0\nend 0\n", 32}).find("too few"),
              std::string::npos);
    EXPECT_NE(errorOf("plumb-replay 2\npacked 1\n\x81\nend 0\n").find("no number of ticks"),
              std::string::npos);
    for (const std::string& change : {std::string{"\x40\x01"}, std::string{"\x47\x80\x80\x01"}})
        EXPECT_NE(errorOf(reportOf(change + "\x01", 1)).find("input that no device gives"), std::string::npos)
            << "no key";
    EXPECT_NE(errorOf("plumb-replay 1\npacked 0\n\nend 0\n").find("unknown keyword"), std::string::npos)
        << "an older format";
}

}  // namespace
}  // namespace plumb
