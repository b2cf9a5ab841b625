#pragma once

#include <vector>

/// Exact solutions of experiments that need more than a one-line formula, in double precision.
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
/// Parameters of both rods of a double pendulum; the mass cancels out.
struct PendulumForm {
    double length = 1.0;   ///< distance from hinge to centre of mass, and between the hinges, m
    double inertia = 0.0;  ///< moment of inertia about the centre of mass per mass, m2
    double gravity = 10.0;
};
/// Integrates a double pendulum with Runge-Kutta 4 and steps of at most 20 µs.
DoublePendulum swing(DoublePendulum state, const PendulumForm& form, double seconds);
/// Energy of a double pendulum per mass, J/kg.
double energyOf(const DoublePendulum& state, const PendulumForm& form);

/// Angles from the horizontal, rad, of a chain of `count` equal rods of `length`
/// (m) between two posts of equal height, `span` (m) apart. The slope of a rod
/// is the weight between it and the middle over the horizontal tension.
std::vector<double> chainAngles(int count, double length, double span);
/// Parameter a of the catenary y = a cosh(x / a), m, for a chain of this length over this span.
double catenaryOf(double length, double span);

/// Limit of the cotangent of a ladder's angle with the floor,
/// above which it slips. The floor has friction, the wall none.
double ladderSlips(double friction, double halfLength, double halfThickness);

/// Minimum ratio of thickness to middle radius of a semicircular arch of stones (H. Milankovitch, 1907).
inline constexpr double kArchStands = 0.1075;

}  // namespace plumb::accuracy
