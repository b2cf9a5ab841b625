#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/text.hpp"

namespace plumb {

enum class LogLevel : std::uint8_t { Detail, Note, Warning, Error };

struct LogLine {
    LogLevel level = LogLevel::Note;
    std::string channel;  ///< "Engine", "Assets", "Input", "Physics", "Collision", …
    std::string text;
};

using LogSink = std::function<void(const LogLine&)>;

/// Receives log lines. Default: prints `[Channel] text`, notes to stdout, warnings and errors to stderr.
/// @return the previous sink, so that a test or a panel can restore it
LogSink setLogSink(LogSink sink);

/// Drops lines below this level. The default is LogLevel::Note.
void setLogLevel(LogLevel level);

void writeLog(LogLevel level, std::string_view channel, std::string text);

template <class... Arguments>
void logNote(std::string_view channel, std::string_view pattern, const Arguments&... arguments) {
    writeLog(LogLevel::Note, channel, format(pattern, arguments...));
}
template <class... Arguments>
void logWarning(std::string_view channel, std::string_view pattern, const Arguments&... arguments) {
    writeLog(LogLevel::Warning, channel, format(pattern, arguments...));
}
inline void logWarning(std::string_view channel, const Error& error) {
    writeLog(LogLevel::Warning, channel, error.text());
}
inline void logError(std::string_view channel, const Error& error) {
    writeLog(LogLevel::Error, channel, error.text());
}

}  // namespace plumb
