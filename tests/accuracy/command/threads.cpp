#include "tests/accuracy/command/threads.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace plumb::accuracy {

int processors() {
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, unsigned{kMaxThreads}));
}

void onThreads(int threads, std::size_t count, const std::function<void(std::size_t)>& act,
               const ShowDone& show) {
    std::atomic<std::size_t> next{0};
    std::mutex telling;
    std::size_t done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            act(i);
            const std::lock_guard lock{telling};
            ++done;
            if (show) show(done, count);
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
}

}  // namespace plumb::accuracy
