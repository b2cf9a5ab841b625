#include "core/log.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(LogTest, errorsTakeTextsAndPatternsAsNotesAndWarningsDo) {
    std::vector<std::string> lines;
    const LogSink before =
        setLogSink([&](const LogLine& line) { lines.push_back(line.channel + ": " + line.text); });
    const std::string text = "a text with {} in it";
    logError("Game", "there is no exit");
    logError("Game", "{} of {} doors", 1, 2);
    logError("Game", text);
    logError("Game", Error{"door", "it is closed", "open it"});
    logError("Game", {"door", "it is closed", "open it"});
    setLogSink(before);
    EXPECT_EQ(lines, (std::vector<std::string>{
                         "Game: there is no exit", "Game: 1 of 2 doors", "Game: a text with {} in it",
                         "Game: door: it is closed; open it", "Game: door: it is closed; open it"}));
}

TEST(LogTest, notesArePrintedToStdoutAndWarningsAndErrorsToStderr) {
    setLogSink(nullptr);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    logNote("Game", "a note");
    logWarning("Game", "a warning");
    logError("Game", "an error");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "[Game] a note\n");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "[Game] warning: a warning\n[Game] error: an error\n");
}

TEST(LogTest, linesBelowTheLevelAreDropped) {
    constexpr LogLevel kLevels[] = {LogLevel::Detail, LogLevel::Note, LogLevel::Warning, LogLevel::Error};
    std::vector<LogLevel> seen;
    const LogSink before = setLogSink([&](const LogLine& line) { seen.push_back(line.level); });
    for (const LogLevel level : kLevels) writeLog(level, "Game", "text");
    EXPECT_EQ(seen, (std::vector<LogLevel>{kLevels + 1, kLevels + 4})) << "the default is Note";
    for (std::size_t least = 0; least < 4; ++least) {
        setLogLevel(kLevels[least]);
        seen.clear();
        for (const LogLevel level : kLevels) writeLog(level, "Game", "text");
        EXPECT_EQ(seen, (std::vector<LogLevel>{kLevels + least, kLevels + 4}));
    }
    setLogLevel(LogLevel::Note);
    setLogSink(before);
}

}  // namespace
}  // namespace plumb
