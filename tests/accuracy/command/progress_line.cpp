#include "tests/accuracy/command/progress_line.hpp"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

#include "core/text.hpp"

namespace plumb::accuracy {

std::string timeLeft(double spent, double part) {
    if (spent < 2.0 || part < 0.01 || part >= 1.0) return {};
    const double left = spent * (1.0 - part) / part;
    return left < 90.0 ? format(", about {} s left", static_cast<int>(left) + 1)
                       : format(", about {} min left", static_cast<int>(left / 60.0 + 0.5));
}

void ProgressLine::show(std::size_t done, std::size_t all) {
    const std::size_t percent = 100 * done / std::max<std::size_t>(all, 1);
    const bool terminal = isatty(STDERR_FILENO) != 0;
    if (percent == shown_ || (!terminal && percent < shown_ + 10 && done != all)) return;
    shown_ = percent;
    const std::string left = timeLeft(wallSeconds() - start_, 0.01 * static_cast<double>(percent));
    std::fprintf(stderr, "%s%zu of %zu %s%s%s", terminal ? "\r\033[K" : "", done, all, what_.c_str(),
                 left.c_str(), terminal && done != all ? "" : "\n");
}

}  // namespace plumb::accuracy
