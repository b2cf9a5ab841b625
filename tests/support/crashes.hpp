#pragma once

#include <limits>

#include <gtest/gtest.h>

#include "tests/support/sanitized.hpp"

namespace plumb::test {

/// Tests of programs that crash. Sanitizers report crashes themselves.
class CrashTest : public testing::Test {
protected:
    void SetUp() override {
        if (kSanitized) GTEST_SKIP() << "the sanitizer reports crashes";
    }
};

inline void writeToNull() {
    volatile int* volatile nowhere = nullptr;  // not known to the compiler
    *nowhere = 1;
}

/// Recurs without end. @return never
// NOLINTNEXTLINE(misc-no-recursion)
inline int overflow(volatile int* depth) {
    volatile char room[4096];
    *depth = *depth + 1;
    room[0] = 0;
    return *depth > std::numeric_limits<int>::max() - 1 ? 0 : overflow(depth) + room[0];
}

}  // namespace plumb::test
