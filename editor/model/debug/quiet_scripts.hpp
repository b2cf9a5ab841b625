#pragma once

#include <memory>

#include "core/log.hpp"

namespace plumb::editor {

/// Drops the log lines of scripts while it exists and `drops` is true: those of ticks that run again were
/// logged before.
class QuietScripts {
public:
    explicit QuietScripts(bool drops = true) : drops_{std::make_shared<bool>(drops)} {
        before_ = std::make_shared<LogSink>();
        *before_ = setLogSink([drop = drops_, before = before_](const LogLine& line) {
            if (!*drop || line.channel != "Script") (*before)(line);
        });
    }
    ~QuietScripts() { setLogSink(*before_); }
    QuietScripts(const QuietScripts&) = delete;
    QuietScripts& operator=(const QuietScripts&) = delete;

    void set(bool drops) { *drops_ = drops; }

private:
    std::shared_ptr<bool> drops_;
    std::shared_ptr<LogSink> before_;
};

}  // namespace plumb::editor
