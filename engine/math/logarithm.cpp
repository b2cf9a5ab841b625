#include "math/logarithm.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace plumb {

namespace {

constexpr double kLn2 = 0.69314718055994530942;
constexpr double kLn10 = 2.30258509299404568402;
constexpr float kMin = -45.0f;  // less than log10 of the smallest float

/// ln on [1/sqrt 2, sqrt 2] by the series of artanh: ln m = 2 artanh((m - 1) / (m + 1)).
double logarithmNearOne(double m) {
    const double z = (m - 1.0) / (m + 1.0);
    const double s = z * z;
    return 2.0 * z * (1.0 + s * (1.0 / 3 + s * (1.0 / 5 + s * (1.0 / 7 + s * (1.0 / 9 + s * (1.0 / 11))))));
}

}  // namespace

float logarithm10(float x) {
    if (!(x > 0.0f)) return kMin;
    if (x > std::numeric_limits<float>::max()) return 38.6f;
    // A double holds every float as a normal number.
    const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(x));
    int exponent = static_cast<int>(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
    if (m > 1.41421356237309504880) {
        m *= 0.5;
        ++exponent;
    }
    return static_cast<float>((logarithmNearOne(m) + exponent * kLn2) / kLn10);
}

}  // namespace plumb
