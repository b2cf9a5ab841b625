#include "core/crash.hpp"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/crashes.hpp"

namespace plumb {

/// Not inlined and exported, so that a back trace names it. @return the quotient
__attribute__((noinline, visibility("default"))) int quotientOfCrashTest(int a, volatile int* b) {
    return a / *b;
}

namespace {

using test::overflow, test::writeToNull;

class Crash : public test::CrashTest {};

TEST_F(Crash, ofASystemIsReportedWithItsNameAndTheRemedyAndEndsByItsSignal) {
    const auto crash = [] {
        reportCrashes("run it again");
        const Running outer{"OuterSystem"};
        { const Running inner{"InnerSystem"}; }
        writeToNull();
    };
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGSEGV),
                "crashed: SIGSEGV.*running: OuterSystem\nrun it again\n");
}

TEST_F(Crash, outsideOfSystemsSaysSo) {
    const auto crash = [] {
        reportCrashes("");
        { const Running running{"FormerSystem"}; }
        std::abort();
    };
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGABRT), "SIGABRT.*running: no system or handler\n");
}

TEST_F(Crash, byRecursionWithoutEndIsReported) {
    const auto crash = [] {
        reportCrashes("run it again");
        const Running running{"DeepSystem"};
        volatile int depth = 0;
        std::exit(overflow(&depth));
    };
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGSEGV), "running: DeepSystem\nrun it again\n");
}

#if defined(__x86_64__) && defined(__GLIBC__)  // others divide by zero without a trap
TEST_F(Crash, byADivisionHasABackTraceWithTheProgramsFile) {
    const auto crash = [] {
        reportCrashes("");
        volatile int zero = 0;
        std::exit(quotientOfCrashTest(1, &zero));
    };
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGFPE),
                "SIGFPE.*back trace.*core_tests.*\\[0x[0-9a-f]+\\]");
}

/// Matches a report whose first frame is in quotientOfCrashTest(), perhaps after the system's function that
/// calls the handler, and whose frames all have an address.
struct BackTrace {
    using is_gtest_matcher = void;

    bool MatchAndExplain(const std::string& report, std::ostream*) const {
        constexpr std::uintptr_t kLongest = 128;  // bytes of that function
        std::vector<std::uintptr_t> frames;
        for (std::size_t at = report.find("[0x"); at != std::string::npos; at = report.find("[0x", at + 1))
            frames.push_back(std::stoull(report.substr(at + 1), nullptr, 16));
        const auto start = reinterpret_cast<std::uintptr_t>(&quotientOfCrashTest);
        const auto isFault = [&](std::uintptr_t at) { return at >= start && at < start + kLongest; };
        return frames.size() > 2 && (isFault(frames[0]) || isFault(frames[1])) &&
               std::find(frames.begin(), frames.end(), 0u) == frames.end();
    }
    void DescribeTo(std::ostream* out) const { *out << "has a back trace from the fault on"; }
    void DescribeNegationTo(std::ostream* out) const { *out << "has no such back trace"; }
};

TEST_F(Crash, hasABackTraceThatBeginsWhereItHappened) {
    testing::FLAGS_gtest_death_test_style = "fast";  // the child has the same addresses
    const auto crash = [] {
        reportCrashes("");
        volatile int zero = 0;
        std::exit(quotientOfCrashTest(1, &zero));
    };
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGFPE), BackTrace{});
}
#endif

TEST_F(Crash, prints512BytesOfALongRemedy) {
    const auto crash = [] {
        reportCrashes(std::string(511, 'x') + "yz");
        std::abort();
    };
    EXPECT_EXIT(crash(), ::testing::KilledBySignal(SIGABRT), "xxxxy\n");
}

TEST_F(Crash, leavesSignalsAloneThatAreHandledAlready) {
    const auto crash = [] {
        std::signal(SIGSEGV, [](int) { std::_Exit(5); });
        reportCrashes("");
        writeToNull();
    };
    EXPECT_EXIT(crash(), ::testing::ExitedWithCode(5), "^$");
}

}  // namespace
}  // namespace plumb
