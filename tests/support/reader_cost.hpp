#pragma once

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/sanitized.hpp"

namespace plumb::test {

/// Checks that a function that reads a small file stays below limits of CPU time (independent of other
/// programs) and of memory. Checks only the time if the system does not report the peak memory of a
/// process, and with sanitizers, which keep freed memory.
class ReaderCost {
public:
    static constexpr std::clock_t kMaxMilliseconds = kSanitized ? 20000 : 2000;
    static constexpr std::int64_t kMaxBytes = std::int64_t{512} << 20;

    ReaderCost() {
        std::ofstream{"/proc/self/clear_refs"} << "5";  // resets the peak memory
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
    /// Returns a value of /proc/self/status, converted from KiB to bytes; 0 if there is none.
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
