#include "core/task_pool.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
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

TEST(TaskPool, aPartThatWaitsForAllOtherThreadsIsReached) {
    constexpr int kThreads = 4;
    TaskPool pool{kThreads};
    for (int round = 0; round < 20; ++round) {
        std::atomic<int> here{0};
        std::atomic<bool> isLate{false};
        // Each thread has one part, and each part waits for all the others: the shares are one part each.
        pool.run(kThreads, [&](int, int) {
            ++here;
            const double end = wallSeconds() + 5.0;
            while (here.load() < kThreads && !isLate.load()) {
                if (wallSeconds() > end) isLate = true;
                std::this_thread::yield();
            }
        });
        ASSERT_FALSE(isLate.load()) << "a thread did not work";
    }
}

TEST(TaskPool, roundsOfAllSizesBelowAndAboveTheNumberOfThreadsAreComplete) {
    for (const int threads : {2, 3, 5}) {
        TaskPool pool{threads};
        for (const int count : {0, 1, 2, 3, 4, 5, 6, 7, 100, 65534, 65535, 65536, 65537, 131071}) {
            std::vector<std::uint8_t> times(static_cast<std::size_t>(count) + 1);
            pool.run(count, [&](int part, int) { ++times[static_cast<std::size_t>(part)]; });
            EXPECT_EQ(std::count(times.begin(), times.end() - 1, 1), count) << threads << " threads";
            EXPECT_EQ(times.back(), 0) << "no part beyond the last";
        }
    }
}

TEST(TaskPool, aPoolThatSleptWorksAgain) {
    TaskPool pool{3};
    for (int round = 0; round < 3; ++round) {
        std::this_thread::sleep_for(std::chrono::milliseconds{5});  // far longer than threads spin
        std::atomic<int> here{0};
        pool.run(3, [&](int, int) {
            ++here;
            const double end = wallSeconds() + 0.05;
            while (here.load() < 3 && wallSeconds() < end) std::this_thread::yield();
        });
        EXPECT_EQ(here.load(), 3);
    }
}

TEST(TaskPool, oneThreadDoesAllPartsInOrderAndIsNotTimed) {
    TaskPool pool{1};
    pool.isTimed = true;
    std::vector<int> order;
    pool.run(5, [&](int part, int thread) { order.push_back(10 * part + thread); });
    EXPECT_EQ(order, (std::vector<int>{0, 10, 20, 30, 40}));
    EXPECT_EQ(pool.times().rounds, 0.0);
    EXPECT_EQ(pool.times().busy, std::vector<double>{0.0});
}

/// A scheduler that does the parts backwards, and counts its calls.
struct Backwards {
    int calls = 0;
    std::vector<int> order;
};

TEST(TaskPool, anotherSchedulerDoesThePartsIfThereIsMoreThanOne) {
    Backwards scheduler;
    TaskPool pool{3,
                  [](void* owner, int count, TaskPool::Call task, void* context) {
                      ++static_cast<Backwards*>(owner)->calls;
                      for (int part = count; part-- > 0;) task(context, part, part % 3);
                  },
                  &scheduler};
    EXPECT_EQ(pool.threads(), 3);
    const auto add = [&](int part, int thread) { scheduler.order.push_back(10 * part + thread); };
    pool.run(4, add);
    EXPECT_EQ(scheduler.calls, 1);
    EXPECT_EQ(scheduler.order, (std::vector<int>{30, 22, 11, 0}));
    pool.run(1, add);
    pool.run(0, add);
    EXPECT_EQ(scheduler.calls, 1) << "the caller does a single part itself";
    EXPECT_EQ(scheduler.order.size(), 5u);
    EXPECT_EQ(pool.times().busy, std::vector<double>(3));
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
    EXPECT_LE(times.busy[0] + times.busy[1], 2.0 * times.rounds + 1e-3);
    pool.isTimed = false;
    work();
    EXPECT_EQ(pool.times().rounds, times.rounds);
    EXPECT_EQ(pool.times().busy, times.busy);
    pool.isTimed = true;
    const double start = wallSeconds();
    work();
    const double wall = wallSeconds() - start;
    EXPECT_GT(pool.times().rounds, times.rounds);
    EXPECT_LE(pool.times().rounds - times.rounds, wall);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_GE(pool.times().busy[i], times.busy[i]);
        EXPECT_LE(pool.times().busy[i] - times.busy[i], wall);
    }
}

}  // namespace
}  // namespace plumb
