#include "core/task_pool.hpp"

#include <algorithm>

#include "core/assert.hpp"
#include "core/clock.hpp"
#include "core/os.hpp"

#if defined(__x86_64__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace plumb {

namespace {

/// Hint for the CPU core that this thread is in a spin loop.
void relaxCore() {
#if defined(__x86_64__) || defined(_M_X64)
    _mm_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

// The next round begins a few microseconds after the last one, or only with the next
// step. Spinning covers the first case; about 0.1 ms of it costs less than waking up.
constexpr int kSpins = 4000;
constexpr int kYields = 20;
// Helping a thread that is about to finish its share only makes its cache line move between cores.
constexpr int kSpinsBeforeHelp = 8;
constexpr int kMaxParts = 0xffff;  // per round: counted in 16 bits

/// The parts of a share that are not taken yet, in one word for compare-and-swap:
/// the round in the high half, then the end and the next part. The round prevents
/// a thread that was interrupted from taking a part of a later round.
struct Parts {
    std::uint32_t round;
    std::uint16_t end;
    std::uint16_t next;
};
constexpr std::uint64_t pack(Parts parts) {
    return std::uint64_t{parts.round} << 32 | std::uint64_t{parts.end} << 16 | parts.next;
}
constexpr Parts unpack(std::uint64_t word) {
    return {static_cast<std::uint32_t>(word >> 32), static_cast<std::uint16_t>(word >> 16),
            static_cast<std::uint16_t>(word)};
}

}  // namespace

/// The work of one thread, in a cache line of its own: a waiting
/// thread reads nothing that others write except its next work.
struct alignas(64) TaskPool::Share {
    std::atomic<std::uint64_t> parts{0};
    // Written only when all parts of the last round are done, so what
    // a thread reads here before it takes a part belongs to that part.
    std::atomic<Call> call{nullptr};
    std::atomic<void*> context{nullptr};
    std::atomic<int> begin{0};  // offset of the round's part numbers
    std::atomic<bool> isAsleep{false};
    std::atomic<bool> stops{false};
    std::atomic<bool> isTimed{false};
    alignas(64) std::atomic<std::uint32_t> wakeUps{0};
    std::atomic<double> busy{0.0};  // s: Times::busy

    void wake() {
        isAsleep.store(false, std::memory_order_relaxed);
        wakeUps.fetch_add(1, std::memory_order_release);
        wakeUps.notify_one();
    }

    [[nodiscard]] bool isEmpty() const {
        const Parts left = unpack(parts.load(std::memory_order_relaxed));
        return left.next >= left.end;
    }

    /// Runs half of the remaining parts, from the front of the own share or from the end of another thread's:
    /// so threads rarely collide at this word, and some parts remain for threads that are done early.
    /// @return number of parts
    int runSome(bool own, int thread) {
        std::uint64_t word = parts.load(std::memory_order_acquire);
        for (;;) {
            Parts left = unpack(word);
            if (left.next >= left.end) return 0;
            const Call task = call.load(std::memory_order_relaxed);
            void* const with = context.load(std::memory_order_relaxed);
            const int first = begin.load(std::memory_order_relaxed);
            const int count = (left.end - left.next + 1) / 2;
            const int part = own ? left.next : left.end - count;
            if (own) {
                left.next = static_cast<std::uint16_t>(left.next + count);
            } else {
                left.end = static_cast<std::uint16_t>(part);
            }
            if (!parts.compare_exchange_weak(word, pack(left), std::memory_order_acq_rel,
                                             std::memory_order_acquire))
                continue;
            for (int i = 0; i < count; ++i) task(with, first + part + i, thread);
            return count;
        }
    }
};

TaskPool::TaskPool(int threads) : threads_{os::hasThreads() ? threads : 1} {
    PLUMB_ASSERT(threads >= 1, "a pool has at least the caller's thread");
    shares_ = std::make_unique<Share[]>(static_cast<std::size_t>(threads_));
    for (int i = 1; i < threads_; ++i) workers_.emplace_back([this, i] { work(i); });
}

TaskPool::TaskPool(int threads, Foreign foreign, void* owner)
    : threads_{threads}, foreign_{foreign}, owner_{owner} {
    PLUMB_ASSERT(threads >= 1, "a scheduler has at least one thread");
}

TaskPool::~TaskPool() {
    for (std::size_t i = 1; i <= workers_.size(); ++i) {
        shares_[i].stops.store(true, std::memory_order_release);
        shares_[i].wake();
    }
    for (std::thread& worker : workers_) worker.join();
}

TaskPool::Times TaskPool::times() const {
    Times times{rounds_, std::vector<double>(static_cast<std::size_t>(threads_))};
    for (std::size_t i = 0; shares_ != nullptr && i < times.busy.size(); ++i)
        times.busy[i] = shares_[i].busy.load(std::memory_order_relaxed);
    return times;
}

/// @return number of parts that this thread ran
int TaskPool::workOff(int thread) {
    Share& own = shares_[static_cast<std::size_t>(thread)];
    const bool timed = own.isTimed.load(std::memory_order_relaxed);
    const double start = timed ? wallSeconds() : 0.0;
    int did = 0;
    while (const int some = own.runSome(true, thread)) did += some;
    for (int i = 1; i < threads_; ++i) {
        Share& other = shares_[static_cast<std::size_t>((thread + i) % threads_)];
        for (int spin = 0; spin < kSpinsBeforeHelp && !other.isEmpty(); ++spin) relaxCore();
        while (const int some = other.runSome(false, thread)) did += some;
    }
    if (timed && did > 0) {
        const double busy = own.busy.load(std::memory_order_relaxed) + (wallSeconds() - start);
        own.busy.store(busy, std::memory_order_relaxed);
    }
    return did;
}

void TaskPool::run(int count, Call call, void* context) {
    if (count <= 1 || threads_ == 1) {
        for (int part = 0; part < count; ++part) call(context, part, 0);
        return;
    }
    if (foreign_ != nullptr) return foreign_(owner_, count, call, context);
    for (int begin = 0; begin < count; begin += kMaxParts)
        runRound(begin, std::min(count, begin + kMaxParts), call, context);
}

void TaskPool::runRound(int begin, int end, Call call, void* context) {
    const double start = isTimed ? wallSeconds() : 0.0;
    ++round_;
    const int count = end - begin, helped = std::min(threads_, count);
    done_.store(0, std::memory_order_relaxed);
    // The caller's own share last, because the caller starts with it immediately.
    for (int i = helped; i-- > 0;) {
        Share& share = shares_[static_cast<std::size_t>(i)];
        share.call.store(call, std::memory_order_relaxed);
        share.context.store(context, std::memory_order_relaxed);
        share.begin.store(begin, std::memory_order_relaxed);
        share.isTimed.store(isTimed, std::memory_order_relaxed);
        const auto part = [&](int n) { return static_cast<std::uint16_t>(std::int64_t{count} * n / helped); };
        share.parts.store(pack({round_, part(i + 1), part(i)}), std::memory_order_release);
        // A thread that falls asleep at this moment is not woken: then others run its share.
        if (share.isAsleep.load(std::memory_order_relaxed)) share.wake();
    }
    const int own = workOff(0);
    // Waits only for parts that have begun: not for a worker that currently has no core.
    for (int spin = 0; done_.load(std::memory_order_acquire) != count - own; ++spin) {
        spin < kSpins ? relaxCore() : std::this_thread::yield();
    }
    if (isTimed) rounds_ += wallSeconds() - start;
}

/// Waits for parts of a round other than `round`. @return false when the pool is destroyed
bool TaskPool::waitForWork(Share& own, std::uint32_t round) {
    const auto isDue = [&] {
        return unpack(own.parts.load(std::memory_order_acquire)).round != round ||
               own.stops.load(std::memory_order_relaxed);
    };
    for (int spin = 0; spin < kSpins + kYields && !isDue(); ++spin) {
        spin < kSpins ? relaxCore() : std::this_thread::yield();
    }
    while (!isDue()) {
        const std::uint32_t seen = own.wakeUps.load(std::memory_order_acquire);
        own.isAsleep.store(true, std::memory_order_seq_cst);
        if (!isDue()) own.wakeUps.wait(seen, std::memory_order_acquire);
        own.isAsleep.store(false, std::memory_order_relaxed);
    }
    return !own.stops.load(std::memory_order_acquire);
}

void TaskPool::work(int thread) {
    Share& own = shares_[static_cast<std::size_t>(thread)];
    std::uint32_t round = 0;
    while (waitForWork(own, round)) {
        round = unpack(own.parts.load(std::memory_order_acquire)).round;
        if (const int did = workOff(thread); did > 0) done_.fetch_add(did, std::memory_order_release);
    }
}

}  // namespace plumb
