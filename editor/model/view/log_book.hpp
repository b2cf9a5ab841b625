#pragma once

#include <cstdint>
#include <deque>
#include <functional>

#include "core/clock.hpp"
#include "core/log.hpp"

namespace plumb::editor {

/// A line, and when it was said.
struct LogEntry : LogLine {
    double seconds = 0.0;    ///< since the book was made
    std::int64_t tick = -1;  ///< of the game that played; -1: none did
};

/// Keeps the last lines of the log from the moment it is made, so that the console also shows what was said
/// before there was a window. What listened before still hears all.
class LogBook {
public:
    static constexpr std::size_t kLines = 5000;

    LogBook() {
        before_ = setLogSink([this](const LogLine& line) {
            lines_.push_back({line, wallSeconds() - start_, tick ? tick() : -1});
            if (lines_.size() > kLines) lines_.pop_front();
            ++count_, ++revision_;
            if (before_) before_(line);
        });
    }
    ~LogBook() { setLogSink(before_); }
    LogBook(const LogBook&) = delete;
    LogBook& operator=(const LogBook&) = delete;

    [[nodiscard]] const std::deque<LogEntry>& lines() const { return lines_; }
    /// Lines there have ever been; grows also when old ones are forgotten.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// Grows when something was said, and when all was forgotten.
    [[nodiscard]] std::size_t revision() const { return revision_; }
    void clear() { lines_.clear(), ++revision_; }

    std::function<std::int64_t()> tick;  ///< of the game that plays, or -1; must not log

private:
    std::deque<LogEntry> lines_;
    double start_ = wallSeconds();
    std::size_t revision_ = 0;
    std::size_t count_ = 0;
    LogSink before_;
};

}  // namespace plumb::editor
