#include "core/watchdog.hpp"

#include <chrono>

#include "core/os.hpp"

namespace plumb {
namespace {

constexpr int kLooks = 20;  // in the longest time

}  // namespace

Watchdog::Watchdog(double seconds, Found found) : pause_{seconds / kLooks}, found_{found} {
    if (os::hasThreads()) thread_ = std::thread{[this] { watch(); }};
}

Watchdog::~Watchdog() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard guard{lock_};
        stops_ = true;
    }
    stop_.notify_one();
    thread_.join();
}

void Watchdog::watch() {
    std::uint64_t seen = 0;
    int looks = 0;
    std::unique_lock guard{lock_};
    while (!stop_.wait_for(guard, std::chrono::duration<double>{pause_}, [this] { return stops_; })) {
        const std::uint64_t now = changes_.load(std::memory_order_relaxed);
        looks = now == seen ? looks + 1 : 0;
        seen = now;
        if (now % 2 == 1 && looks == kLooks) found_();
    }
}

}  // namespace plumb
