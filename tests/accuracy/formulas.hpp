#pragma once

#include <vector>

/// Exact solutions for the experiments that need more than a one-line formula, in double precision.
namespace plumb::accuracy {

/// Period of a pendulum with `amplitude` (rad), s.
/// Source: C. F. Gauss's arithmetic-geometric mean for the complete elliptic integral.
double pendulumPeriod(double amplitude, double length, double gravity);

/// Position of a damped oscillator of angular frequency
/// omega (rad/s) that was released at rest at position 1.
/// @param damping  damping ratio; 1: critical
double springPlace(double time, double omega, double damping);

/// State of a double pendulum: two rods with discs at their ends; angles from the vertical.
struct DoublePendulum {
    double angleA = 0.0, angleB = 0.0;  ///< rad
    double spinA = 0.0, spinB = 0.0;    ///< rad/s
};
/// Parameters common to both rods of a double pendulum. The result does not depend on their mass.
struct PendulumForm {
    double length = 1.0;    ///< distance from hinge to centre of mass, and between the hinges, m
    double inertia = 0.0;   ///< moment of inertia about the centre of mass per mass, m2
    double gravity = 10.0;  ///< m/s2
};
/// Returns a double pendulum's state after `seconds`, integrated by Runge-Kutta 4 in steps of at most 20 µs.
DoublePendulum swing(DoublePendulum state, const PendulumForm& form, double seconds);
/// Energy of a double pendulum per mass, J/kg.
double energyOf(const DoublePendulum& state, const PendulumForm& form);

/// Returns the angle from the horizontal, rad, of each rod of a hanging chain: `count` equal rods of `length`
/// (m) between two posts of equal height, `span` (m) apart. The slope of a rod is the weight of the chain
/// between this rod and the chain's middle, divided by the horizontal tension.
std::vector<double> chainAngles(int count, double length, double span);
/// Parameter a of the catenary y = a cosh(x / a), m, for a chain of this length over this span.
double catenaryOf(double length, double span);

/// Returns the limit of cot(angle between ladder and floor): above it, the ladder slips.
/// The floor has friction, the wall none.
double ladderSlips(double friction, double halfLength, double halfThickness);

/// Minimum ratio of thickness to middle radius of a semicircular arch of stones (H. Milankovitch, 1907).
inline constexpr double kArchStands = 0.1075;

}  // namespace plumb::accuracy
