#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

namespace plumb {

/// Threads that work on one task at a time, together with the caller. Created once, used for every step.
///
/// Each round of work consists of numbered parts. Each thread has a share of consecutive parts, the same ones
/// in every round of the same size, so that its data stays in its caches; a thread that is done takes parts
/// from the ends of the other shares. It is undefined which thread does a part, so parts must not depend on
/// each other and must write to separate memory. Then the results are the same for any number
/// of threads.
class TaskPool {
public:
    /// @param threads  including the caller's, at least 1; where programs cannot start any, the caller's
    /// alone
    explicit TaskPool(int threads);
    /// Uses the threads of another scheduler instead of its own: `foreign` calls `task(taskContext,
    /// part, thread)` for every part in 0..count-1, on any thread, and returns when all are done.
    /// `thread` is in 0..threads-1; no two threads use the same number at the same time.
    using Call = void (*)(void* context, int part, int thread);
    using Foreign = void (*)(void* owner, int count, Call task, void* taskContext);
    TaskPool(int threads, Foreign foreign, void* owner);
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    [[nodiscard]] int threads() const { return threads_; }

    /// Wall time of all rounds since the pool was created, while `isTimed`.
    struct Times {
        double rounds = 0.0;       ///< s: wall time of the caller, including waits for other threads
        std::vector<double> busy;  ///< s: working time of each thread, the caller first
    };
    [[nodiscard]] Times times() const;
    bool isTimed = false;  ///< costs two clock reads per thread and round

    /// Runs `task(part, thread)` for every part in 0..count-1 and waits for all. `thread` is 0..threads()-1.
    /// @pre not called from a task
    template <class Task>
    void run(int count, Task&& task) {
        using Plain = std::remove_reference_t<Task>;
        run(
            count, [](void* context, int part, int thread) { (*static_cast<Plain*>(context))(part, thread); },
            const_cast<void*>(static_cast<const void*>(&task)));
    }

private:
    struct Share;

    void run(int count, Call call, void* context);
    void runRound(int begin, int end, Call call, void* context);
    void work(int thread);
    [[nodiscard]] int workOff(int thread);
    [[nodiscard]] bool waitForWork(Share& own, std::uint32_t round);

    int threads_ = 1;
    Foreign foreign_ = nullptr;
    void* owner_ = nullptr;
    std::unique_ptr<Share[]> shares_;  // one for each thread, the caller's first
    std::vector<std::thread> workers_;
    std::uint32_t round_ = 0;
    double rounds_ = 0.0;                   // s: Times::rounds
    alignas(64) std::atomic<int> done_{0};  // number of finished parts of this round
};

}  // namespace plumb
