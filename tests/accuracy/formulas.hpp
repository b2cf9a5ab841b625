#pragma once

#include <vector>

/// Exact solutions that need more than a line, in double precision.
namespace plumb::accuracy {

/// s: period of a pendulum with `amplitude` (rad).
/// Source: C. F. Gauss's arithmetic-geometric mean for the complete elliptic integral.
double pendulumPeriod(double amplitude, double length, double gravity);

/// Position of an oscillator of rate omega (rad/s) that was released at 1, at rest.
/// @param damping  ratio to critical
double springPlace(double time, double omega, double damping);

/// Two rods with discs at their ends, one hanging from the other; angles from the vertical.
struct DoublePendulum {
    double angleA = 0.0, angleB = 0.0;  ///< rad
    double spinA = 0.0, spinB = 0.0;    ///< rad/s
};
/// Parameters common to both; the mass cancels out.
struct PendulumForm {
    double length = 1.0;   ///< m: from hinge to centre of mass, and from the first hinge to the second
    double inertia = 0.0;  ///< m2: about the centre of mass, for each kilogram
    double gravity = 10.0;
};
/// By Runge-Kutta 4 with steps of at most 20 µs.
DoublePendulum swing(DoublePendulum state, const PendulumForm& form, double seconds);
/// J for each kilogram.
double energyOf(const DoublePendulum& state, const PendulumForm& form);

/// rad from horizontal, of each of `count` equal rods of `length` (m) that hang
/// as a chain between two posts of equal height, `span` (m) apart. Each rod's
/// slope is the weight between it and the middle over the horizontal tension.
std::vector<double> chainAngles(int count, double length, double span);
/// m: a of y = a cosh(x / a) for a chain of this length over this span.
double catenaryOf(double length, double span);

/// Limit for a ladder with this half length and half thickness, on a floor with this friction
/// and a frictionless wall: it slips if the cotangent of its angle with the floor is larger.
double ladderSlips(double friction, double halfLength, double halfThickness);

/// Minimum ratio of thickness to middle radius of a semicircular arch of stones (H. Milankovitch, 1907).
inline constexpr double kArchStands = 0.1075;

}  // namespace plumb::accuracy
