#include "tests/accuracy/formulas.hpp"

#include <cmath>
#include <numbers>

namespace plumb::accuracy {

namespace {

double meanOf(double a, double b) {
    while (std::fabs(a - b) > 1.0e-15 * a) {
        const double middle = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = middle;
    }
    return a;
}

DoublePendulum rateOf(const DoublePendulum& s, const PendulumForm& form) {
    // Lagrange's equations: M (spinA', spinB') = right hand side.
    const double square = form.length * form.length, cosine = std::cos(s.angleA - s.angleB),
                 sine = std::sin(s.angleA - s.angleB);
    const double aa = 2.0 * square + form.inertia, bb = square + form.inertia, ab = square * cosine;
    const double pull = form.gravity * form.length;
    const double a = -square * sine * s.spinB * s.spinB - 2.0 * pull * std::sin(s.angleA);
    const double b = square * sine * s.spinA * s.spinA - pull * std::sin(s.angleB);
    const double determinant = aa * bb - ab * ab;
    return {s.spinA, s.spinB, (bb * a - ab * b) / determinant, (aa * b - ab * a) / determinant};
}

DoublePendulum along(const DoublePendulum& s, const DoublePendulum& rate, double h) {
    return {s.angleA + h * rate.angleA, s.angleB + h * rate.angleB, s.spinA + h * rate.spinA,
            s.spinB + h * rate.spinB};
}

/// Finds the root of an increasing function by bisection.
template <class Function>
double rootOf(double low, double high, Function&& grows) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (grows(middle) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

double pendulumPeriod(double amplitude, double length, double gravity) {
    return 2.0 * std::numbers::pi * std::sqrt(length / gravity) / meanOf(1.0, std::cos(0.5 * amplitude));
}

double springPlace(double time, double omega, double damping) {
    const double decay = damping * omega;
    if (damping == 1.0) return std::exp(-decay * time) * (1.0 + decay * time);
    if (damping < 1.0) {
        const double rate = omega * std::sqrt(1.0 - damping * damping);
        return std::exp(-decay * time) * (std::cos(rate * time) + decay / rate * std::sin(rate * time));
    }
    const double rate = omega * std::sqrt(damping * damping - 1.0);
    const double slow = rate - decay, fast = -rate - decay;
    return (slow * std::exp(fast * time) - fast * std::exp(slow * time)) / (slow - fast);
}

DoublePendulum swing(DoublePendulum state, const PendulumForm& form, double seconds) {
    const int steps = static_cast<int>(std::ceil(seconds / 2.0e-5));
    const double h = seconds / steps;
    for (int i = 0; i < steps; ++i) {
        const DoublePendulum a = rateOf(state, form);
        const DoublePendulum b = rateOf(along(state, a, 0.5 * h), form);
        const DoublePendulum c = rateOf(along(state, b, 0.5 * h), form);
        const DoublePendulum d = rateOf(along(state, c, h), form);
        for (const auto& [rate, part] : {std::pair{a, 1.0}, {b, 2.0}, {c, 2.0}, {d, 1.0}})
            state = along(state, rate, part * h / 6.0);
    }
    return state;
}

double energyOf(const DoublePendulum& s, const PendulumForm& form) {
    const double square = form.length * form.length;
    const double motion = 0.5 * (2.0 * square + form.inertia) * s.spinA * s.spinA +
                          0.5 * (square + form.inertia) * s.spinB * s.spinB +
                          square * std::cos(s.angleA - s.angleB) * s.spinA * s.spinB;
    return motion - form.gravity * form.length * (2.0 * std::cos(s.angleA) + std::cos(s.angleB));
}

std::vector<double> chainAngles(int count, double length, double span) {
    const auto angleOf = [&](int rod, double weight) {
        return std::atan(weight * (rod - 0.5 * (count - 1)));
    };
    // The span of the chain decreases with the ratio w of a rod's weight
    // to the horizontal tension, so bisection finds the w of a given span.
    const double weight = rootOf(0.0, 1.0e3, [&](double w) {
        double reach = 0.0;
        for (int i = 0; i < count; ++i) reach += length * std::cos(angleOf(i, w));
        return span - reach;
    });
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) angles.push_back(angleOf(i, weight));
    return angles;
}

double catenaryOf(double length, double span) {
    return rootOf(1.0e-2 * span, 1.0e4 * span,
                  [&](double a) { return length - 2.0 * a * std::sinh(0.5 * span / a); });
}

double ladderSlips(double friction, double halfLength, double halfThickness) {
    // Two corners of one long side of the ladder touch the floor and the
    // wall. The center of mass is half a thickness away from this side.
    return 2.0 * friction + halfThickness / halfLength;
}

}  // namespace plumb::accuracy
