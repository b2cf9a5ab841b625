#include <atomic>
#include <vector>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"
#include "tests/accuracy/command/progress_line.hpp"
#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/command/words.hpp"

// Tests of the code shared by the commands of plumb-accuracy.

namespace plumb::accuracy {
namespace {

struct Words {
    bool quick = false;
    int threads = 0;
    std::string wrong;

    explicit Words(std::vector<std::string_view> words) {
        const Flag flags[] = {{"--quick", &quick}};
        wrong = readWords(words, flags, [this](std::string_view word, std::string_view value) -> std::string {
            return word == "--threads" ? readCount(value, kMaxThreads, threads) : kUnknownWord;
        });
    }
};

TEST(CommandWords, flagsAndOptionsWithAValueAreParsed) {
    EXPECT_TRUE(Words({}).wrong.empty());
    const Words words{{"--threads", "256", "--quick"}};
    EXPECT_EQ(words.wrong, "");
    EXPECT_TRUE(words.quick);
    EXPECT_EQ(words.threads, 256);
    EXPECT_FALSE((Words{{"--threads", "1"}}.quick));
}

TEST(CommandWords, errorsNameTheInvalidOption) {
    for (const std::string_view bad : {"0", "-1", "257", "2.5", "two", ""}) {
        const Words words{{"--threads", bad}};
        EXPECT_NE(words.wrong.find(format("--threads {}: ", bad)), std::string::npos) << words.wrong;
    }
    EXPECT_NE((Words{{"--sizes", "1"}}.wrong.find("--sizes 1: ")), std::string::npos);
    EXPECT_NE((Words{{"--quick", "--threads"}}.wrong.find("'--threads'")), std::string::npos);
}

TEST(OnThreads, everyIndexRunsOnceAndProgressIsCounted) {
    for (const int threads : {1, 2, 5}) {
        std::vector<std::atomic<int>> done(100);
        std::vector<std::size_t> shown;
        onThreads(
            threads, done.size(), [&](std::size_t i) { ++done[i]; },
            [&](std::size_t count, std::size_t all) {
                EXPECT_EQ(all, done.size());
                shown.push_back(count);
            });
        for (const auto& times : done) EXPECT_EQ(times, 1);
        ASSERT_EQ(shown.size(), done.size());
        for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_EQ(shown[i], i + 1);
    }
    EXPECT_GE(processors(), 1);
}

TEST(TimeLeft, isProportionalToTheRemainingPart) {
    EXPECT_EQ(timeLeft(1.0, 0.5), "");
    EXPECT_EQ(timeLeft(30.0, 0.001), "");
    EXPECT_EQ(timeLeft(30.0, 1.0), "");
    EXPECT_EQ(timeLeft(30.5, 0.5), ", about 31 s left");
    EXPECT_EQ(timeLeft(60.0, 0.1), ", about 9 min left");
}

TEST(TablePage, isSelfContained) {
    const std::string page = tablePage("A & B", "<table></table>");
    EXPECT_NE(page.find("<title>A &amp; B</title>"), std::string::npos);
    EXPECT_NE(page.find("<h1>A &amp; B</h1><table></table></html>"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos);
}

}  // namespace
}  // namespace plumb::accuracy
