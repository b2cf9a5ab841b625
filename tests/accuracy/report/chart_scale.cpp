#include "tests/accuracy/report/chart_scale.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace plumb::accuracy {

LogScale::LogScale(double low, double high, double pixelLow, double pixelHigh)
    : low_{low}, high_{std::max(high, low * 1.5)}, pixelLow_{pixelLow}, pixelHigh_{pixelHigh} {}

double LogScale::at(double value) const {
    const double inside = std::isnan(value) ? high_ : std::clamp(value, low_, high_);
    const double part = std::log(inside / low_) / std::log(high_ / low_);
    return pixelLow_ + part * (pixelHigh_ - pixelLow_);
}

std::vector<LogScale::Tick> LogScale::ticks() const {
    const int first = static_cast<int>(std::floor(std::log10(low_) + 1.0e-9));
    const int last = static_cast<int>(std::ceil(std::log10(high_) - 1.0e-9));
    const int decades = last - first, stride = decades > 9 ? 2 : 1;
    std::vector<Tick> ticks;
    for (int power = first; power <= last; ++power) {
        for (const double part : {1.0, 2.0, 5.0}) {
            const double value = part * std::pow(10.0, power);
            if (value < low_ * (1.0 - 1.0e-9) || value > high_ * (1.0 + 1.0e-9)) continue;
            if (part == 1.0) {
                ticks.push_back({value, power % stride == 0});
            } else if (decades <= 3) {
                ticks.push_back({value, true});
            }
        }
    }
    return ticks;
}

std::string tickText(double value) {
    if (value >= 0.9999e-3 && value < 1.0e6) {
        const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(value) - 1.0e-9)));
        return fixedText(value, digits);
    }
    const double power = std::floor(std::log10(value) + 1.0e-9);
    return format("{}e{}", static_cast<int>(std::lround(value / std::pow(10.0, power))),
                  static_cast<int>(power));
}

}  // namespace plumb::accuracy
