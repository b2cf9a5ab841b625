#include "tests/accuracy/formulas.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace plumb::accuracy {
namespace {

constexpr double kPi = std::numbers::pi;

/// Complete elliptic integral K(k), computed from its definition with Simpson's rule.
double ellipticIntegral(double k) {
    constexpr int kParts = 20000;
    const auto at = [&](int i) {
        const double sine = std::sin(0.5 * kPi * i / kParts);
        return 1.0 / std::sqrt(1.0 - k * k * sine * sine);
    };
    double sum = at(0) + at(kParts);
    for (int i = 1; i < kParts; ++i) sum += (i % 2 == 0 ? 2.0 : 4.0) * at(i);
    return sum * 0.5 * kPi / kParts / 3.0;
}

TEST(Formulas, thePeriodOfAPendulumIsFourTimesTheEllipticIntegral) {
    for (const double degrees : {1.0, 90.0, 170.0}) {
        const double amplitude = degrees * kPi / 180.0;
        const double wanted = 4.0 * ellipticIntegral(std::sin(0.5 * amplitude)) * std::sqrt(1.5 / 10.0);
        EXPECT_NEAR(pendulumPeriod(amplitude, 1.5, 10.0), wanted, 1e-9 * wanted) << degrees;
    }
    EXPECT_NEAR(pendulumPeriod(1e-4, 1.0, 10.0), 2.0 * kPi / std::sqrt(10.0), 1e-8);
}

TEST(Formulas, theDampedSpringSatisfiesItsDifferentialEquation) {
    constexpr double kOmega = 3.0, kStep = 1e-4;
    for (const double damping : {0.0, 0.2, 1.0, 2.5}) {
        EXPECT_NEAR(springPlace(0.0, kOmega, damping), 1.0, 1e-12);
        for (const double time : {0.3, 1.1}) {
            const double before = springPlace(time - kStep, kOmega, damping);
            const double now = springPlace(time, kOmega, damping);
            const double after = springPlace(time + kStep, kOmega, damping);
            const double speed = (after - before) / (2.0 * kStep);
            const double bend = (after - 2.0 * now + before) / (kStep * kStep);
            EXPECT_NEAR(bend, -kOmega * kOmega * now - 2.0 * damping * kOmega * speed, 1e-4)
                << damping << " " << time;
        }
    }
}

TEST(Formulas, theDoublePendulumConservesEnergyAndHasTheKnownSmallModes) {
    const PendulumForm form{.inertia = 0.005};
    const DoublePendulum wild = swing({2.0, 2.5, 0.0, 0.0}, form, 2.0);
    EXPECT_NEAR(energyOf(wild, form), energyOf({2.0, 2.5, 0.0, 0.0}, form), 1e-9);
    // Slow mode of two equal point masses on strings of length L: omega^2 = (2 - sqrt 2) g / L, and the angle
    // of the lower string is sqrt 2 times that of the upper one.
    const double small = 1e-4, omega = std::sqrt((2.0 - std::sqrt(2.0)) * 10.0);
    const DoublePendulum slow = swing({small, std::sqrt(2.0) * small, 0.0, 0.0}, {}, 0.7);
    EXPECT_NEAR(slow.angleA, small * std::cos(0.7 * omega), 1e-10);
    EXPECT_NEAR(slow.angleB, std::sqrt(2.0) * small * std::cos(0.7 * omega), 1e-10);
}

TEST(Formulas, aChainOfManyRodsHangsAsACatenary) {
    constexpr int kRods = 2000;
    constexpr double kLength = 10.0, kSpan = 8.0;
    const std::vector<double> angles = chainAngles(kRods, kLength / kRods, kSpan);
    const double a = catenaryOf(kLength, kSpan);
    EXPECT_NEAR(2.0 * a * std::sinh(0.5 * kSpan / a), kLength, 1e-9);
    double x = 0.0, y = 0.0, lowest = 0.0;
    for (const double angle : angles) {
        x += kLength / kRods * std::cos(angle);
        y += kLength / kRods * std::sin(angle);
        lowest = std::min(lowest, y);
    }
    EXPECT_NEAR(x, kSpan, 1e-9);
    EXPECT_NEAR(y, 0.0, 1e-9);
    EXPECT_NEAR(lowest, a * (1.0 - std::cosh(0.5 * kSpan / a)), 1e-4);
}

TEST(Formulas, aThinLadderSlipsAtTwiceTheFriction) {
    EXPECT_DOUBLE_EQ(ladderSlips(0.4, 2.0, 0.0), 0.8);
    EXPECT_DOUBLE_EQ(ladderSlips(0.4, 2.0, 0.05), 0.825);
}

}  // namespace
}  // namespace plumb::accuracy
