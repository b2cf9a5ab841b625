#pragma once

#include <string>
#include <vector>

namespace plumb::accuracy {

/// Maps a range of positive numbers to a range of pixels, logarithmically.
class LogScale {
public:
    LogScale(double low, double high, double pixelLow, double pixelHigh);

    /// Position on the axis, clamped to its ends.
    [[nodiscard]] double at(double value) const;
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }

    struct Tick {
        double value = 0.0;
        bool named = true;
    };
    /// Whole powers of ten, all or every second one labeled;
    /// with three or fewer of them, also 2 and 5 times each.
    [[nodiscard]] std::vector<Tick> ticks() const;

private:
    double low_, high_, pixelLow_, pixelHigh_;
};

/// "0.01", "1000", "1e-7".
std::string tickText(double value);

}  // namespace plumb::accuracy
