#pragma once

#include <deque>

#include "core/log.hpp"

namespace plumb::editor {

/// Keeps the last lines of the log from the moment it is made, so that the console also shows what was said
/// before there was a window. What listened before still hears all.
class LogBook {
public:
    static constexpr std::size_t kLines = 500;

    LogBook() {
        before_ = setLogSink([this](const LogLine& line) {
            lines_.push_back(line);
            if (lines_.size() > kLines) lines_.pop_front();
            ++count_;
            if (before_) before_(line);
        });
    }
    ~LogBook() { setLogSink(before_); }
    LogBook(const LogBook&) = delete;
    LogBook& operator=(const LogBook&) = delete;

    [[nodiscard]] const std::deque<LogLine>& lines() const { return lines_; }
    /// Lines there have ever been; grows also when old ones are forgotten.
    [[nodiscard]] std::size_t count() const { return count_; }
    void clear() { lines_.clear(); }

private:
    std::deque<LogLine> lines_;
    std::size_t count_ = 0;
    LogSink before_;
};

}  // namespace plumb::editor
