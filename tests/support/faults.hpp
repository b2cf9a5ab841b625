#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/assert.hpp"
#include "core/log.hpp"

namespace plumb::test {

/// Collects the lines of the log, and lets the program go on after a failed assertion, while it exists: so
/// that wrong uses, which report both, are tested alike in builds with and without assertions.
class Faults {
public:
    Faults()
        : handler_{setAssertHandler([](const char*, const char*, int) {})},
          sink_{setLogSink([this](const LogLine& line) { lines_.push_back(line.text); })} {}
    ~Faults() {
        setLogSink(std::move(sink_));
        setAssertHandler(handler_);
    }
    Faults(const Faults&) = delete;
    Faults& operator=(const Faults&) = delete;

    [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
    /// True if a line contains the text.
    [[nodiscard]] bool mention(std::string_view text) const {
        return std::any_of(lines_.begin(), lines_.end(),
                           [&](const std::string& line) { return line.find(text) != std::string::npos; });
    }
    void clear() { lines_.clear(); }

private:
    std::vector<std::string> lines_;
    AssertHandler handler_;
    LogSink sink_;
};

}  // namespace plumb::test
