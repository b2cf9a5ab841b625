#include "math/portable.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace plumb {
namespace {

// Taylor coefficients on [-pi/4, pi/4] in double: the error stays below half a float ulp.
double sineNearZero(double x) {
    const double s = x * x;
    return x * (1.0 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880)))));
}

double cosineNearZero(double x) {
    const double s = x * x;
    return 1.0 +
           s * (-1.0 / 2 + s * (1.0 / 24 + s * (-1.0 / 720 + s * (1.0 / 40320 + s * (-1.0 / 3628800)))));
}

/// arctan on [0, tan(pi/8)] by its series in double.
double arcTangentNearZero(double x) {
    const double s = x * x;
    double sum = 0.0;
    for (int k = 12; k >= 0; --k) {
        sum = 1.0 / (2 * k + 1) - s * sum;
    }
    return x * sum;
}

}  // namespace

SinCos sinCos(float angle) {
    constexpr double kHalfPi = 1.57079632679489661923;
    if (!(std::fabs(angle) < 1.0e9f)) return {0.0f, 1.0f};
    const double quarters = std::floor(static_cast<double>(angle) / kHalfPi + 0.5);
    const double rest = static_cast<double>(angle) - quarters * kHalfPi;
    const auto s = static_cast<float>(sineNearZero(rest));
    const auto c = static_cast<float>(cosineNearZero(rest));
    switch (static_cast<std::int64_t>(quarters) & 3) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

float sine(float angle) { return sinCos(angle).sin; }
float cosine(float angle) { return sinCos(angle).cos; }

float arcTangent(float y, float x) {
    constexpr double kExactPi = 3.14159265358979323846;
    const double ax = std::fabs(static_cast<double>(x));
    const double ay = std::fabs(static_cast<double>(y));
    if (!(ax + ay > 0.0)) return 0.0f;
    const bool steep = ay > ax;
    const double ratio = steep ? ax / ay : ay / ax;
    constexpr double kTanEighth = 0.41421356237309504880;
    double angle = ratio > kTanEighth ? kExactPi / 4 + arcTangentNearZero((ratio - 1.0) / (ratio + 1.0))
                                      : arcTangentNearZero(ratio);
    if (steep) angle = kExactPi / 2 - angle;
    if (x < 0.0f) angle = kExactPi - angle;
    return static_cast<float>(y < 0.0f ? -angle : angle);
}

float exponential(float x) {
    if (x != x) return 0.0f;
    if (x < -87.0f) return 0.0f;
    if (x > 88.0f) return std::numeric_limits<float>::max();
    constexpr double kLog2 = 0.69314718055994530942;
    const double powers = std::floor(static_cast<double>(x) / kLog2 + 0.5);
    const double r = static_cast<double>(x) - powers * kLog2;
    double sum = 1.0;
    for (int k = 9; k >= 1; --k) {
        sum = 1.0 + r / k * sum;
    }
    const auto exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(powers) + 1023);
    return static_cast<float>(sum * std::bit_cast<double>(exponent << 52));
}

int floorToInt(float x) {
    if (x != x) return 0;
    constexpr float kMax = 1073741824.0f;
    const float floored = std::floor(x);
    return static_cast<int>(floored < -kMax ? -kMax : floored > kMax ? kMax : floored);
}

}  // namespace plumb
