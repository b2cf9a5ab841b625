#include "core/watchdog.hpp"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace plumb {
namespace {

std::atomic<int> found{0};

void sleepFor(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>{seconds}); }

class WatchdogTest : public testing::Test {
protected:
    WatchdogTest() { found = 0; }

    Watchdog watchdog_{0.2, [] { ++found; }};
};

TEST_F(WatchdogTest, findsEachTooLongTickOnce) {
    for (int tick = 1; tick <= 2; ++tick) {
        watchdog_.begin();
        for (int i = 0; i < 100 && found < tick; ++i) sleepFor(0.1);
        sleepFor(0.5);
        EXPECT_EQ(found, tick);
        watchdog_.end();
    }
}

TEST_F(WatchdogTest, letsManyTicksAndPausesBetweenThemPass) {
    for (int i = 0; i < 60; ++i) {
        watchdog_.begin();
        sleepFor(0.005);
        watchdog_.end();
    }
    sleepFor(0.5);
    EXPECT_EQ(found, 0);
}

TEST(Watchdog, endsAtOnceWithItsThread) {
    const auto before = std::chrono::steady_clock::now();
    {
        Watchdog watchdog{1000.0, [] { ++found; }};
        watchdog.begin();
    }
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds{20});
}

}  // namespace
}  // namespace plumb
