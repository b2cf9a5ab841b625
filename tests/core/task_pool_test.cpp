#include "core/task_pool.hpp"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(TaskPool, everyPartIsDoneOnceWhateverTheNumberOfThreads) {
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

TEST(TaskPool, whatTasksWroteIsThereWhenRunReturns) {
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

}  // namespace
}  // namespace plumb
