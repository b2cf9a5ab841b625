#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/clock.hpp"

namespace plumb::accuracy {

/// Returns ", about 7 s left", estimated from the fraction
/// `part` of the work done in `spent` seconds; empty if unknown.
std::string timeLeft(double spent, double part);

/// Prints progress: a terminal line that is updated with each percent; in a file one line per 10 %.
class ProgressLine {
public:
    explicit ProgressLine(std::string_view what) : what_{what} {}
    void show(std::size_t done, std::size_t all);

private:
    std::string what_;
    std::size_t shown_ = 0;  // last printed progress, percent
    double start_ = wallSeconds();
};

}  // namespace plumb::accuracy
