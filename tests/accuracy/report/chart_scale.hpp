#pragma once

#include <string>
#include <vector>

namespace plumb::accuracy {

/// Logarithmic map from a range of positive numbers to a range of pixels.
class LogScale {
public:
    LogScale(double low, double high, double pixelLow, double pixelHigh);

    /// Returns the pixel position of a value, clamped to the ends of the axis.
    [[nodiscard]] double at(double value) const;
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }

    struct Tick {
        double value = 0.0;
        bool named = true;  ///< true: with a label
    };
    /// Returns tick marks at powers of ten, all or every second one labeled; if the
    /// axis has at most three of them, also marks at 2 and 5 times each power.
    [[nodiscard]] std::vector<Tick> ticks() const;

private:
    double low_, high_, pixelLow_, pixelHigh_;
};

/// Formats the label of a tick: "0.01", "1000", "1e-7".
std::string tickText(double value);

}  // namespace plumb::accuracy
