#include "assets/clip_cursor.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

constexpr float kTick = 1.0f / 60.0f;

Animation clipOf(std::vector<float> seconds, LoopMode mode = LoopMode::Loop) {
    Animation clip{"clip", {}, mode};
    for (const float length : seconds)
        clip.frames.push_back({static_cast<int>(clip.frames.size()), 0, length, ""});
    return clip;
}

std::vector<int> played(const Animation& clip, ClipCursor& cursor, float seconds, int times = 1) {
    std::vector<int> frames;
    for (int i = 0; i < times; ++i) {
        advanceClip(clip, clip.loop, cursor, seconds, [&](int frame) { frames.push_back(frame); });
    }
    return frames;
}

TEST(ClipCursor, aFrameOfATenthOfASecondLastsExactlySixTicksForHours) {
    const Animation clip = clipOf({0.1f, 0.1f, 0.1f, 0.1f});
    ClipCursor cursor;
    for (int tick = 1; tick <= 1'000'000; ++tick) {
        played(clip, cursor, kTick);
        ASSERT_EQ(cursor.frame, tick / 6 % 4) << tick;
    }
}

TEST(ClipCursor, framesOfAnyLengthInMillisecondsDoNotDrift) {
    const Animation clip = clipOf({0.08f, 0.033f, 0.25f});  // one cycle lasts 363 ms
    ClipCursor cursor;
    std::int64_t entered = 0;
    for (int tick = 1; tick <= 500'000; ++tick) {
        entered += static_cast<std::int64_t>(played(clip, cursor, kTick).size());
        const std::int64_t units = std::int64_t{tick} * 12000;  // elapsed time, multiples of 1/720000 s
        const std::int64_t rest = units % 261360;
        ASSERT_EQ(entered, units / 261360 * 3 + (rest >= 57600) + (rest >= 57600 + 23760) + 1) << tick;
    }
}

TEST(ClipCursor, everyFrameBeginsExactlyOnceForAnyTimeSteps) {
    const Animation clip = clipOf({0.05f, 0.1f, 0.02f, 0.3f});
    ClipCursor whole;
    std::vector<int> expected;
    for (int i = 0; i < 100; ++i) {
        for (const int frame : played(clip, whole, 0.125f)) expected.push_back(frame);
    }
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        ClipCursor cursor;
        std::vector<int> frames;
        int left = 12500;  // remaining time, ms
        while (left > 0) {
            const int step = std::min(left, 1 + static_cast<int>(random.below(200)));
            left -= step;
            for (const int frame : played(clip, cursor, static_cast<float>(step) / 1000.0f))
                frames.push_back(frame);
        }
        ASSERT_EQ(frames, expected);
        ASSERT_EQ(cursor.frame, whole.frame);
    }
}

TEST(ClipCursor, aClipOfModeOnceStopsAtItsLastFrame) {
    const Animation clip = clipOf({0.1f, 0.1f, 0.1f}, LoopMode::Once);
    ClipCursor cursor;

    EXPECT_EQ(played(clip, cursor, kTick, 17), (std::vector<int>{0, 1, 2}));
    EXPECT_FALSE(cursor.ended);
    EXPECT_EQ(played(clip, cursor, kTick, 100), std::vector<int>{});
    EXPECT_TRUE(cursor.ended);
    EXPECT_EQ(cursor.frame, 2);
}

TEST(ClipCursor, aPingPongClipReversesAtBothEndsWithoutRepeatingThem) {
    const Animation clip = clipOf({0.1f, 0.1f, 0.1f}, LoopMode::PingPong);
    ClipCursor cursor;

    EXPECT_EQ(played(clip, cursor, 0.1f, 9), (std::vector<int>{0, 1, 2, 1, 0, 1, 2, 1, 0, 1}));
    EXPECT_TRUE(cursor.ended);
    const Animation two = clipOf({0.1f, 0.1f}, LoopMode::PingPong);
    ClipCursor other;
    EXPECT_EQ(played(two, other, 0.1f, 4), (std::vector<int>{0, 1, 0, 1, 0}));
    EXPECT_TRUE(other.ended);
}

TEST(ClipCursor, speedZeroHoldsTheFrameAndNegativeSpeedPlaysBackwards) {
    const Animation clip = clipOf({0.1f, 0.2f, 0.1f});
    ClipCursor cursor;

    EXPECT_EQ(played(clip, cursor, 0.0f, 100), std::vector<int>{0});
    EXPECT_EQ(played(clip, cursor, -kTick, 24), (std::vector<int>{2, 1, 0}));

    const Animation pingPong = clipOf({0.1f, 0.1f, 0.1f}, LoopMode::PingPong);
    ClipCursor back{1, 0.05f, 1, false};
    EXPECT_EQ(played(pingPong, back, -0.1f, 4), (std::vector<int>{0, 1, 2, 1}));
}

TEST(ClipCursor, playingForwardAndBackwardReturnsToTheStart) {
    for (const LoopMode mode : {LoopMode::Loop, LoopMode::PingPong}) {
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            SCOPED_TRACE(seed);
            Random random = Random::seeded(seed);
            const Animation clip = clipOf({0.05f, 0.1f, 0.02f, 0.3f}, mode);
            ClipCursor cursor{1, 0.05f, 1, false};
            const float seconds = static_cast<float>(random.below(800)) / 1000.0f;
            played(clip, cursor, seconds);
            played(clip, cursor, -seconds);
            ASSERT_EQ(cursor.frame, 1);
            ASSERT_EQ(cursor.timer, 0.05f);
            ASSERT_EQ(cursor.direction, 1);
        }
    }
}

TEST(ClipCursor, hugeAndInvalidTimesEndImmediately) {
    for (const float seconds : {1e30f, -1e30f, std::nanf(""), INFINITY, -INFINITY, 1e6f}) {
        for (const LoopMode mode : {LoopMode::Loop, LoopMode::Once, LoopMode::PingPong}) {
            const Animation clip = clipOf({0.001f, 0.001f, 0.002f}, mode);
            ClipCursor cursor;
            EXPECT_LE(played(clip, cursor, seconds).size(), 16u);
            EXPECT_GE(cursor.frame, 0);
            EXPECT_LT(cursor.frame, 3);
        }
    }
}

TEST(ClipCursor, oneHugeStepEndsAtTheSameFrameAsManySmallSteps) {
    const Animation clip = clipOf({0.1f, 0.2f, 0.3f});
    ClipCursor once;
    ClipCursor often;
    played(clip, once, 1000.25f);
    played(clip, often, 0.25f, 4001);
    EXPECT_EQ(once.frame, often.frame);
    EXPECT_EQ(once.timer, often.timer);
}

TEST(ClipCursor, anEmptyClipAndACursorOutsideItAreHarmless) {
    ClipCursor cursor{99, -5.0f, 1, false};
    EXPECT_TRUE(played(clipOf({}), cursor, 1.0f).empty());
    played(clipOf({0.1f}), cursor, kTick, 100);
    EXPECT_EQ(cursor.frame, 0);
}

class StateMachineTest : public ::testing::Test {
protected:
    void SetUp() override {
        set_.clips = playerAnimations;
        set_.parameters = {{"speed", ParameterKind::Float, 0.0f}, {"hit", ParameterKind::Trigger, 0.0f}};
        set_.states = {{"idle", 0, 1.0f}, {"run", 1, 1.0f}, {"hurt", 2, 1.0f}};
        set_.transitions = {
            {AnimationTransition::kAnyState, 2, {{1, Comparison::Equal, 1.0f}}, false},
            {0, 1, {{0, Comparison::Greater, 5.0f}}, false},
            {1, 0, {{0, Comparison::LessOrEqual, 5.0f}}, false},
            {2, 0, {}, true},
        };
    }
    AnimationSet set_;
    std::vector<float> parameters_{0.0f, 0.0f};
};

TEST_F(StateMachineTest, theFirstTransitionWhoseConditionsHoldIsPerformed) {
    EXPECT_EQ(advanceStateMachine(set_, 0, parameters_, false), 0);
    parameters_[0] = 6.0f;
    EXPECT_EQ(advanceStateMachine(set_, 0, parameters_, false), 1);
    EXPECT_EQ(advanceStateMachine(set_, 1, parameters_, false), 1);
    parameters_[1] = 1.0f;
    EXPECT_EQ(advanceStateMachine(set_, 0, parameters_, false), 2);
}

TEST_F(StateMachineTest, aTriggerIsResetByTheTransitionThatUsesIt) {
    parameters_[1] = 1.0f;
    EXPECT_EQ(advanceStateMachine(set_, 1, parameters_, false), 2);
    EXPECT_EQ(parameters_[1], 0.0f);
    EXPECT_EQ(advanceStateMachine(set_, 2, parameters_, false), 2);
    EXPECT_EQ(advanceStateMachine(set_, 2, parameters_, true), 0);
}

TEST_F(StateMachineTest, aTransitionFromAnyStateDoesNotRestartItsTargetState) {
    parameters_[1] = 1.0f;
    EXPECT_EQ(advanceStateMachine(set_, 2, parameters_, false), 2);
    EXPECT_EQ(parameters_[1], 1.0f);
}

TEST_F(StateMachineTest, missingParametersCountAsZero) {
    std::vector<float> none;
    EXPECT_EQ(advanceStateMachine(set_, 1, none, false), 0);
}

}  // namespace
}  // namespace plumb
