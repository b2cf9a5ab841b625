#pragma once

#include <atomic>
#include <string_view>

namespace plumb {

/// Makes this program print a report when it crashes (a wrong access to memory, a division of integers by
/// zero, abort(), an exception that is not caught): the signal, what was running, see Running, and a back
/// trace. It then ends by the same signal. Does nothing for signals that are handled already, as by a
/// sanitizer. A stack overflow is reported on the calling thread only. See setCrashReport() for a file.
/// @param remedy  a line of the report
void reportCrashes(std::string_view remedy);

/// Says what this thread runs as long as it lives, for the report of a crash of this thread.
class Running {
public:
    /// @param name  of a system or handler; must stay valid until the program ends
    explicit Running(std::string_view name) : before_{current} { set(name); }
    ~Running() { set(before_); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    /// The innermost one; empty: none.
    static constinit thread_local std::string_view current;

private:
    static void set(std::string_view name) {
        current = name;
        std::atomic_signal_fence(std::memory_order_seq_cst);  // a signal handler reads it
    }

    std::string_view before_;
};

}  // namespace plumb
