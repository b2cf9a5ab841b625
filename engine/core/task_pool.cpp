#include "core/task_pool.hpp"

#include "core/assert.hpp"

#if defined(__x86_64__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace plumb {

namespace {

/// Tells the core that it only waits.
void relaxCore() {
#if defined(__x86_64__) || defined(_M_X64)
    _mm_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

// A round of work comes some microseconds after the last one or not before the next step: waiting without
// sleep catches the first case, and giving the core away catches the second.
constexpr int kSpins = 2000;
constexpr int kYields = 20;

}  // namespace

TaskPool::TaskPool(int threads) {
    PLUMB_ASSERT(threads >= 1, "a pool has at least the caller's thread");
    for (int i = 1; i < threads; ++i) workers_.emplace_back([this, i] { work(i); });
}

TaskPool::~TaskPool() {
    {
        const std::lock_guard lock{mutex_};
        stop_ = true;
        round_.fetch_add(1, std::memory_order_release);
    }
    wake_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void TaskPool::takeParts(int thread) {
    for (int part = next_.fetch_add(1, std::memory_order_relaxed); part < count_;
         part = next_.fetch_add(1, std::memory_order_relaxed)) {
        call_(context_, part, thread);
    }
}

void TaskPool::run(int count, Call call, void* context) {
    if (count <= 1 || workers_.empty()) {
        for (int part = 0; part < count; ++part) call(context, part, 0);
        return;
    }
    call_ = call;
    context_ = context;
    count_ = count;
    next_.store(0, std::memory_order_relaxed);
    busy_.store(static_cast<int>(workers_.size()), std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_seq_cst);
    if (asleep_.load(std::memory_order_seq_cst) > 0) {
        { const std::lock_guard lock{mutex_}; }
        wake_.notify_all();
    }
    takeParts(0);
    for (int spin = 0; busy_.load(std::memory_order_acquire) != 0; ++spin) {
        spin < kSpins ? relaxCore() : std::this_thread::yield();
    }
}

void TaskPool::work(int thread) {
    std::uint32_t seen = 0;
    for (;;) {
        for (int spin = 0; round_.load(std::memory_order_acquire) == seen && spin < kSpins + kYields;
             ++spin) {
            spin < kSpins ? relaxCore() : std::this_thread::yield();
        }
        if (round_.load(std::memory_order_acquire) == seen) {
            std::unique_lock lock{mutex_};
            asleep_.fetch_add(1, std::memory_order_seq_cst);
            wake_.wait(lock, [&] { return round_.load(std::memory_order_seq_cst) != seen; });
            asleep_.fetch_sub(1, std::memory_order_relaxed);
        }
        // Rounds follow each other only after every worker has finished, so none is ever missed.
        ++seen;
        if (stop_) return;
        takeParts(thread);
        busy_.fetch_sub(1, std::memory_order_release);
    }
}

}  // namespace plumb
