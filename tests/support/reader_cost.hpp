#pragma once

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace plumb::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

/// What reading one small file may take, whatever stands in it: time of the processor, which does not grow
/// when other programs run, and memory. Where the system does not say how much memory a process had at its
/// peak, and under sanitizers, which keep memory that was given back, only the time is looked at.
class ReaderCost {
public:
    static constexpr std::clock_t kMaxMilliseconds = kSanitized ? 20000 : 2000;
    static constexpr std::int64_t kMaxBytes = std::int64_t{512} << 20;

    ReaderCost() {
        std::ofstream{"/proc/self/clear_refs"} << "5";  // the peak begins anew
        before_ = bytesOf("VmRSS:");
    }

    template <class Read>
    void expectSmall(Read read) const {
        const std::clock_t begin = std::clock();
        read();
        const std::clock_t taken = (std::clock() - begin) / (CLOCKS_PER_SEC / 1000);
        EXPECT_LE(taken, kMaxMilliseconds) << "ms of the processor to read a small file";
        const std::int64_t grown = kSanitized ? 0 : bytesOf("VmHWM:") - before_;
        EXPECT_LE(grown, kMaxBytes) << "bytes to read a small file";
    }

private:
    /// A line of /proc/self/status, which counts in KiB; 0 where there is none.
    static std::int64_t bytesOf(const std::string& name) {
        std::ifstream status{"/proc/self/status"};
        for (std::string line; std::getline(status, line);) {
            if (line.rfind(name, 0) != 0) continue;
            return std::strtoll(line.c_str() + name.size(), nullptr, 10) * 1024;
        }
        return 0;
    }

    std::int64_t before_ = 0;
};

}  // namespace plumb::test
