#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/clock.hpp"

namespace plumb::accuracy {

/// ", about 7 s left": the time for the rest if `part` of all took `spent` seconds; empty if unknown.
std::string timeLeft(double spent, double part);

/// Progress of a run: one line of a terminal, updated with each
/// percent; if the output is a file, a line for each tenth.
class ProgressLine {
public:
    explicit ProgressLine(std::string_view what) : what_{what} {}
    void show(std::size_t done, std::size_t all);

private:
    std::string what_;
    std::size_t shown_ = 0;  // percent
    double start_ = wallSeconds();
};

}  // namespace plumb::accuracy
