#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace plumb {

/// Notices that a part of a program takes too long, on a thread of its own. Time in which the whole program
/// is stopped, as by a debugger or a machine that sleeps, does not count.
class Watchdog {
public:
    using Found = void (*)();

    /// @param seconds  longest time between begin() and end()
    /// @param found    called once for each time that is longer, while it lasts, on the watchdog's thread
    Watchdog(double seconds, Found found);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    // Not from several threads.
    void begin() { change(); }
    void end() { change(); }

private:
    void change() { changes_.store(changes_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed); }
    void watch();

    double pause_;  // s between two looks
    Found found_;
    std::atomic<std::uint64_t> changes_{0};  // odd: after begin()
    std::mutex lock_;
    std::condition_variable stop_;
    bool stops_ = false;
    std::thread thread_;
};

}  // namespace plumb
