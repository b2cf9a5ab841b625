#include "core/log.hpp"

#include <cstdio>
#include <mutex>
#include <string>
#include <utility>

namespace plumb {
namespace {

void print(const LogLine& line) {
    std::FILE* stream = line.level >= LogLevel::Warning ? stderr : stdout;
    const char* mark = line.level == LogLevel::Warning ? "warning: "
                       : line.level == LogLevel::Error ? "error: "
                                                       : "";
    std::fprintf(stream, "[%s] %s%s\n", line.channel.c_str(), mark, line.text.c_str());
    std::fflush(stream);
}

// The only global state of the engine: a program has one log, as it has one stdout.
struct Log {
    std::mutex mutex;
    LogSink sink = &print;
    LogLevel level = LogLevel::Note;
};

Log& theLog() {
    static Log log;
    return log;
}

}  // namespace

LogSink setLogSink(LogSink sink) {
    Log& log = theLog();
    const std::lock_guard lock{log.mutex};
    return std::exchange(log.sink, sink ? std::move(sink) : LogSink{&print});
}

void setLogLevel(LogLevel level) {
    Log& log = theLog();
    const std::lock_guard lock{log.mutex};
    log.level = level;
}

void writeLog(LogLevel level, std::string_view channel, std::string text) {
    Log& log = theLog();
    const std::lock_guard lock{log.mutex};
    if (level >= log.level) {
        log.sink(LogLine{level, std::string{channel}, std::move(text)});
    }
}

}  // namespace plumb
