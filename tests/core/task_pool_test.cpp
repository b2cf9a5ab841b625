#include "core/task_pool.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/clock.hpp"

namespace plumb {
namespace {

TEST(TaskPool, everyPartIsProcessedOnceForAnyNumberOfThreads) {
    for (const int threads : {1, 2, 4, 16}) {
        TaskPool pool{threads};
        for (int round = 0; round < 2000; ++round) {
            std::vector<std::atomic<int>> times(static_cast<std::size_t>(round % 37));
            pool.run(static_cast<int>(times.size()),
                     [&](int part, int) { times[static_cast<std::size_t>(part)].fetch_add(1); });
            for (const std::atomic<int>& count : times) ASSERT_EQ(count.load(), 1) << threads << " " << round;
        }
    }
}

TEST(TaskPool, writesOfTasksAreVisibleAfterRun) {
    TaskPool pool{3};
    std::vector<int> squares(1000);
    for (int round = 1; round <= 200; ++round) {
        pool.run(1000, [&](int part, int) { squares[static_cast<std::size_t>(part)] = part * part * round; });
        long sum = 0;
        for (const int square : squares) sum += square;
        ASSERT_EQ(sum, 332833500L * round);
    }
}

TEST(TaskPool, threadNumbersStayBelowTheNumberOfThreads) {
    TaskPool pool{4};
    EXPECT_EQ(pool.threads(), 4);
    std::atomic<bool> wrong{false};
    pool.run(5000, [&](int, int thread) {
        if (thread < 0 || thread >= 4) wrong = true;
    });
    EXPECT_FALSE(wrong);
}

TEST(TaskPool, anIdleThreadTakesPartsOfOtherThreads) {
    TaskPool pool{2};
    std::atomic<int> done{0};
    std::vector<int> byThread(2);
    pool.run(64, [&](int part, int thread) {
        ++byThread[static_cast<std::size_t>(thread)];
        // The first part of the caller's share waits until all parts are done except those claimed with it.
        for (int spin = 0; part == 0 && spin < 200'000'000 && done.load() < 48; ++spin)
            std::this_thread::yield();
        done.fetch_add(1);
    });
    EXPECT_EQ(done.load(), 64);
    EXPECT_GE(byThread[1], 48) << "its own half, and half of the other's";
}

TEST(TaskPool, itemsMayOutnumberTheParts) {
    TaskPool pool{3};
    std::vector<std::uint8_t> times(200'000);
    pool.run(200'000, [&](int part, int) { ++times[static_cast<std::size_t>(part)]; });
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), 200'000);
}

TEST(TaskPool, timesAreMeasuredPerThread) {
    TaskPool pool{2};
    const auto work = [&] {
        pool.run(8, [](int, int) {
            const double end = wallSeconds() + 1e-3;
            while (wallSeconds() < end) {
            }
        });
    };
    work();
    EXPECT_EQ(pool.times().rounds, 0.0) << "not measured";
    pool.isTimed = true;
    work();
    const TaskPool::Times times = pool.times();
    ASSERT_EQ(times.busy.size(), 2u);
    EXPECT_GE(times.busy[0] + times.busy[1], 8e-3);
    EXPECT_GE(times.rounds, times.busy[0]);
}

}  // namespace
}  // namespace plumb
