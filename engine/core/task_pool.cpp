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
constexpr int kSpins = 4000;
constexpr int kYields = 20;

constexpr std::uint64_t kNoParts = 0xffffffffu;  // the low half of a ticket that was withdrawn

}  // namespace

TaskPool::TaskPool(int threads) {
    PLUMB_ASSERT(threads >= 1, "a pool has at least the caller's thread");
    for (int i = 1; i < threads; ++i) workers_.emplace_back([this, i] { work(i); });
}

TaskPool::TaskPool(int threads, Foreign foreign, void* owner)
    : foreign_{foreign}, owner_{owner}, foreignThreads_{threads} {
    PLUMB_ASSERT(threads >= 1, "a scheduler has at least one thread");
}

TaskPool::~TaskPool() {
    {
        const std::lock_guard lock{mutex_};
        stop_.store(true);
    }
    wake_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

bool TaskPool::takePart(int thread) {
    std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
    for (;;) {
        const auto part = static_cast<std::uint32_t>(ticket);
        const Call call = call_.load(std::memory_order_acquire);
        void* context = context_.load(std::memory_order_acquire);
        if (part >= count_.load(std::memory_order_acquire) || part == kNoParts) return false;
        if (!ticket_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel,
                                           std::memory_order_acquire)) {
            continue;
        }
        call(context, static_cast<int>(part), thread);
        done_.fetch_add(1, std::memory_order_release);
        return true;
    }
}

void TaskPool::run(int count, Call call, void* context) {
    if (foreign_ != nullptr && count > 1) return foreign_(owner_, count, call, context);
    if (count <= 1 || workers_.empty()) {
        for (int part = 0; part < count; ++part) call(context, part, 0);
        return;
    }
    ++round_;
    ticket_.store(round_ << 32 | kNoParts, std::memory_order_seq_cst);
    call_.store(call, std::memory_order_release);
    context_.store(context, std::memory_order_release);
    count_.store(static_cast<std::uint32_t>(count), std::memory_order_release);
    done_.store(0, std::memory_order_relaxed);
    ticket_.store(round_ << 32, std::memory_order_seq_cst);
    if (asleep_.load(std::memory_order_seq_cst) > 0) {
        { const std::lock_guard lock{mutex_}; }
        wake_.notify_all();
    }
    while (takePart(0)) {
    }
    // Only for parts that others have begun: a worker that has no core at the moment is not waited for.
    for (int spin = 0; done_.load(std::memory_order_acquire) != count; ++spin) {
        spin < kSpins ? relaxCore() : std::this_thread::yield();
    }
}

void TaskPool::waitForWork(std::uint64_t seen) {
    const auto sameRound = [&] { return ticket_.load(std::memory_order_seq_cst) >> 32 == seen; };
    for (int spin = 0; spin < kSpins + kYields; ++spin) {
        if (!sameRound() || stop_.load(std::memory_order_relaxed)) return;
        spin < kSpins ? relaxCore() : std::this_thread::yield();
    }
    std::unique_lock lock{mutex_};
    asleep_.fetch_add(1, std::memory_order_seq_cst);
    wake_.wait(lock, [&] { return !sameRound() || stop_.load(); });
    asleep_.fetch_sub(1, std::memory_order_relaxed);
}

void TaskPool::work(int thread) {
    while (!stop_.load(std::memory_order_relaxed)) {
        const std::uint64_t round = ticket_.load(std::memory_order_acquire) >> 32;
        while (takePart(thread)) {
        }
        waitForWork(round);
    }
}

}  // namespace plumb
