#pragma once

#include <string>
#include <vector>

namespace plumb::accuracy {

/// From a range of positive numbers to a range of pixels, by powers of ten.
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
    /// Whole powers of ten, all or every second of them named; over three of them or fewer, 2 and 5 of each
    /// too.
    [[nodiscard]] std::vector<Tick> ticks() const;

private:
    double low_, high_, pixelLow_, pixelHigh_;
};

/// "0.01", "1000", "1e-7".
std::string tickText(double value);

}  // namespace plumb::accuracy
