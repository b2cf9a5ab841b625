#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace plumb {

/// Threads that work on one thing at a time, together with the caller. Made once, used for every step.
///
/// Work is handed out as numbered parts; who takes which part is a matter of chance, so parts must not depend
/// on each other and must write to places of their own. Then results are the same for any number of threads.
class TaskPool {
public:
    /// @param threads  including the caller's, at least 1
    explicit TaskPool(int threads);
    /// Uses the threads of another scheduler instead of its own: `foreign` calls `task(taskContext, part,
    /// thread)` for every part in 0..count-1, on any thread, and returns when all are done. `thread` is a
    /// number in 0..threads-1 that no other thread uses meanwhile.
    using Call = void (*)(void* context, int part, int thread);
    using Foreign = void (*)(void* owner, int count, Call task, void* taskContext);
    TaskPool(int threads, Foreign foreign, void* owner);
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    [[nodiscard]] int threads() const {
        return foreign_ != nullptr ? foreignThreads_ : static_cast<int>(workers_.size()) + 1;
    }

    /// Runs `task(part, thread)` for every part in 0..count-1 and waits for all. `thread` is 0..threads()-1.
    /// @pre not called from within a task
    template <class Task>
    void run(int count, Task&& task) {
        using Plain = std::remove_reference_t<Task>;
        run(
            count, [](void* context, int part, int thread) { (*static_cast<Plain*>(context))(part, thread); },
            const_cast<void*>(static_cast<const void*>(&task)));
    }

private:
    void run(int count, Call call, void* context);
    void work(int thread);
    bool takePart(int thread);
    void waitForWork(std::uint64_t seen);

    std::vector<std::thread> workers_;
    Foreign foreign_ = nullptr;
    void* owner_ = nullptr;
    int foreignThreads_ = 1;
    // What is done in the present round. Whoever takes a part has read what belongs to the ticket it takes:
    // the ticket is withdrawn before these change.
    std::atomic<Call> call_{nullptr};
    std::atomic<void*> context_{nullptr};
    std::atomic<std::uint32_t> count_{0};
    alignas(64) std::atomic<std::uint64_t> ticket_{
        0};                                 // round in the high half, the next part in the low one
    alignas(64) std::atomic<int> done_{0};  // parts
    std::atomic<int> asleep_{0};
    std::atomic<bool> stop_{false};
    std::mutex mutex_;
    std::condition_variable wake_;
    std::uint64_t round_ = 0;
};

}  // namespace plumb
