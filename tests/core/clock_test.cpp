#include "core/clock.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace plumb {
namespace {

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

TEST(Clock, wallTimeIsThatOfTheSteadyClock) {
    double before = wallSeconds();
    for (int i = 0; i < 1000; ++i) {
        const double first = steadySeconds(), now = wallSeconds(), last = steadySeconds();
        ASSERT_LE(first, now);
        ASSERT_LE(now, last);
        ASSERT_GE(now, before) << "it never goes back";
        before = now;
    }
}

TEST(Clock, threadTimeGrowsWithWorkAndNeverFasterThanWallTime) {
    const double wall = wallSeconds(), start = threadSeconds();
    ASSERT_GE(start, 0.0);
    double before = start;
    while (threadSeconds() - start < 5e-3) {
        const double now = threadSeconds();
        ASSERT_GE(now, before);
        ASSERT_LE(now - start, wallSeconds() - wall + 1e-3);
        before = now;
    }
}

TEST(Clock, threadTimeIsThatOfTheCallingThreadAndStandsStillWhileItSleeps) {
    const double start = threadSeconds();
    double other = 0.0;
    std::thread worker{[&] {
        EXPECT_LT(threadSeconds(), 0.1) << "a new thread begins at zero";
        const double first = threadSeconds();
        while (threadSeconds() - first < 5e-3) {
        }
        other = threadSeconds();
    }};
    worker.join();
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
    EXPECT_GE(other, 5e-3);
    EXPECT_LT(threadSeconds() - start, 5e-3) << "neither the other thread's time nor the sleep";
}

}  // namespace
}  // namespace plumb
