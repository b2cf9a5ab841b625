#pragma once

namespace plumb {

// Functions with the same bits on every machine, compiler and flag; the system's differ
// between CPUs. Only + - * / and sqrt are exact everywhere, so only these are used.

inline constexpr float kPi = 3.14159265358979323846f;
inline constexpr float kTau = 6.28318530717958647692f;

struct SinCos {
    float sin;
    float cos;
};

/// Sine and cosine; |error| <= 1.5e-7 for |angle| <= 1e5 rad, 0 and 1 for NaN and |angle| >= 1e9 rad.
SinCos sinCos(float angle);
float sine(float angle);
float cosine(float angle);

/// The angle of (x, y) in [-pi, pi]; 0 for (0, 0). |error| <= 4e-7 rad.
float arcTangent(float y, float x);

/// e^x, relative error <= 1e-6; 0 below -87, the largest finite float above 88.
float exponential(float x);

/// The largest integer not above x, clamped to +-2^30; 0 for NaN.
int floorToInt(float x);

}  // namespace plumb
