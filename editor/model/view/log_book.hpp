#pragma once

#include <cstdint>
#include <deque>
#include <functional>

#include "core/clock.hpp"
#include "core/log.hpp"

namespace plumb::editor {

/// A line of the log with its time.
struct LogEntry : LogLine {
    double seconds = 0.0;    ///< s since the LogBook was created
    std::int64_t tick = -1;  ///< tick of the running game; -1: no game was running
    std::size_t game = 0;    ///< PlayMode::games() when it was logged
};

/// Stores the last lines of the log from its creation on, so that the console also shows lines logged before
/// the window was opened. Forwards all lines to the previous log sink.
class LogBook {
public:
    static constexpr std::size_t kLines = 5000;  ///< maximum number of stored lines

    LogBook() {
        before_ = setLogSink([this](const LogLine& line) {
            lines_.push_back({line, wallSeconds() - start_, tick ? tick() : -1, game ? game() : 0});
            if (lines_.size() > kLines) lines_.pop_front();
            ++count_, ++revision_;
            if (before_) before_(line);
        });
    }
    ~LogBook() { setLogSink(before_); }
    LogBook(const LogBook&) = delete;
    LogBook& operator=(const LogBook&) = delete;

    [[nodiscard]] const std::deque<LogEntry>& lines() const { return lines_; }
    /// Number of lines logged so far, including those no longer stored.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// Changes when a line is added, and when the lines are cleared.
    [[nodiscard]] std::size_t revision() const { return revision_; }
    void clear() { lines_.clear(), ++revision_; }

    std::function<std::int64_t()> tick;  ///< returns the tick of the running game, or -1; must not log
    std::function<std::size_t()> game;   ///< returns PlayMode::games(); must not log

private:
    std::deque<LogEntry> lines_;
    double start_ = wallSeconds();
    std::size_t revision_ = 0;
    std::size_t count_ = 0;
    LogSink before_;
};

}  // namespace plumb::editor
