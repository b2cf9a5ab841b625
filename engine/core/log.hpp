#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

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

/// A text that is known only at run time. Literals are patterns: see format().
template <class Text>
concept RuntimeText = std::convertible_to<const Text&, std::string_view> && !std::is_array_v<Text>;

/// Writes a line to the log; each `{}` of the pattern is replaced by the next argument, as by format().
template <class... Arguments>
void logNote(std::string_view channel, FormatPattern<sizeof...(Arguments)> pattern,
             const Arguments&... arguments) {
    writeLog(LogLevel::Note, channel, format(runtimePattern(pattern.text), arguments...));
}
/// Writes a text as it is.
template <RuntimeText Text>
void logNote(std::string_view channel, const Text& text) {
    writeLog(LogLevel::Note, channel, std::string{std::string_view{text}});
}
template <class... Arguments>
void logWarning(std::string_view channel, FormatPattern<sizeof...(Arguments)> pattern,
                const Arguments&... arguments) {
    writeLog(LogLevel::Warning, channel, format(runtimePattern(pattern.text), arguments...));
}
template <RuntimeText Text>
void logWarning(std::string_view channel, const Text& text) {
    writeLog(LogLevel::Warning, channel, std::string{std::string_view{text}});
}
inline void logWarning(std::string_view channel, const Error& error) {
    writeLog(LogLevel::Warning, channel, error.text());
}
template <class... Arguments>
void logError(std::string_view channel, FormatPattern<sizeof...(Arguments)> pattern,
              const Arguments&... arguments) {
    writeLog(LogLevel::Error, channel, format(runtimePattern(pattern.text), arguments...));
}
template <RuntimeText Text>
void logError(std::string_view channel, const Text& text) {
    writeLog(LogLevel::Error, channel, std::string{std::string_view{text}});
}
inline void logError(std::string_view channel, const Error& error) {
    writeLog(LogLevel::Error, channel, error.text());
}

}  // namespace plumb
