#include "app/frame_pacer.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

/// Number of ticks in `seconds` of frames at `rate` Hz, each up to `jitter` s early or late.
int ticksIn(FramePacer& pacer, double seconds, double rate, float jitter) {
    Random random = Random::seeded(3);
    int ticks = 0;
    double late = 0.0;
    for (int i = 0; i < static_cast<int>(seconds * rate); ++i) {
        const double before = late;
        late = static_cast<double>(random.between(-jitter, jitter));
        ticks += pacer.next(1.0 / rate + late - before).ticks;
    }
    return ticks;
}

TEST(FramePacer, theGameRunsInRealTimeOnEveryDisplayEvenIfItReportsAWrongRate) {
    for (const double rate : {50.0, 59.94, 60.0, 62.0, 65.0, 75.0, 144.0, 165.0}) {
        for (const double said : {0.0, 60.0, rate}) {
            SCOPED_TRACE(testing::Message() << rate << " Hz, reported as " << said);
            FramePacer pacer{said};
            EXPECT_NEAR(ticksIn(pacer, 60.0, rate, 0.001f), 3600, 2);
        }
    }
}

TEST(FramePacer, withoutVsyncFramesAreLimitedToTwiceTheDisplayRate) {
    EXPECT_NEAR(FramePacer{60.0}.rest(0.0003), 1.0 / 120.0 - 0.0003, 1e-9);
    EXPECT_NEAR(FramePacer{144.0}.rest(0.0), 1.0 / 288.0, 1e-9);
    EXPECT_NEAR(FramePacer{}.rest(0.0), 1.0 / FramePacer::kUnknownRate, 1e-9);
    EXPECT_EQ(FramePacer{60.0}.rest(1.0 / 60.0), 0.0) << "vsync has already waited";
    EXPECT_NEAR(FramePacer{60.0}.rest(-1.0), 1.0 / 120.0, 1e-9) << "negative frame time";
}

TEST(FramePacer, clockJitterIsRemovedIfTheDisplayRateIsKnown) {
    FramePacer pacer{144.0};
    Random random = Random::seeded(5);
    double drawnBefore = 0.0;
    int ticks = 0;
    double late = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double before = late;
        late = static_cast<double>(random.between(-0.0003f, 0.0003f));
        const auto frame = pacer.next(1.0 / 144.0 + late - before);
        ticks += frame.ticks;
        const double drawn = ticks + static_cast<double>(frame.alpha);
        if (i > 2) {
            EXPECT_NEAR((drawn - drawnBefore) * 144.0 / 60.0, 1.0, 0.01) << i;
        }
        drawnBefore = drawn;
    }
}

TEST(FramePacer, aPauseFreezesTheImageAndNoTicksAreCaughtUp) {
    FramePacer pacer;
    static_cast<void>(pacer.next(0.1 + 0.4 / 60.0));
    const float alpha = pacer.next(0.0).alpha;
    pacer.pause();
    for (int i = 0; i < 100; ++i) {
        const auto frame = pacer.next(0.1);
        EXPECT_EQ(frame.ticks, 0);
        EXPECT_EQ(frame.alpha, alpha);
    }
    pacer.resume();
    EXPECT_EQ(pacer.next(0.1).ticks, 0) << "the frame that has waited for the end of the pause";
    pacer.resume();  // as the loop does in every frame
    const auto frame = pacer.next(0.1 / 60.0);
    EXPECT_EQ(frame.ticks, 0);
    EXPECT_NEAR(frame.alpha, alpha + 0.1f, 1e-4f);
}

}  // namespace
}  // namespace plumb
