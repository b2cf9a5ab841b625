#include "core/assert.hpp"

#include <csignal>
#include <string>

#include <gtest/gtest.h>

namespace plumb {
namespace {

std::string reported;

void report(const char* sentence, const char* file, int line) {
    reported = std::string{file} + ":" + std::to_string(line) + ": " + sentence;
}

TEST(Assert, theHandlerGetsTheSentenceAndItsPlace) {
    const AssertHandler before = setAssertHandler(&report);
    reported.clear();
    failAssertion("the door is open", "door.cpp", 12);
    EXPECT_EQ(reported, "door.cpp:12: the door is open");
    EXPECT_EQ(setAssertHandler(before), &report) << "the previous one is returned";
}

TEST(Assert, withoutAHandlerItIsPrintedAndTheProgramEnds) {
    const AssertHandler usual = setAssertHandler(&report);
    setAssertHandler(nullptr);
    EXPECT_EXIT(failAssertion("the door is open", "door.cpp", 12), ::testing::KilledBySignal(SIGABRT),
                "door.cpp:12: the door is open\n");
    EXPECT_EQ(setAssertHandler(usual), usual) << "no handler is the default one";
}

TEST(Assert, aConditionIsCheckedOnlyInBuildsWithAssertions) {
    const AssertHandler before = setAssertHandler(&report);
    reported.clear();
    [[maybe_unused]] int checks = 0;
    PLUMB_ASSERT(++checks == 1, "true the first time");
    EXPECT_EQ(reported, "");
    PLUMB_ASSERT(++checks == 1, "false the second time");
    setAssertHandler(before);
    EXPECT_EQ(checks, kAssertions ? 2 : 0);
    EXPECT_EQ(reported.find("false the second time") != std::string::npos, kAssertions);
}

}  // namespace
}  // namespace plumb
