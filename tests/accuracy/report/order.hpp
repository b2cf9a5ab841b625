#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plumb::accuracy {

/// A point of a work-precision diagram: the error reached with an effort.
struct Sample {
    double effort = 0.0;  ///< number of substeps, or time of a step, µs
    double error = 0.0;   ///< in the unit of the scene's figure
};

/// Fitted exponent p of error ~ 1 / effort^p, and its range of validity.
struct Order {
    double power = 0.0;
    double first = 0.0, last = 0.0;  ///< smallest and largest effort of the fitted points
    int points = 0;                  ///< number of fitted points; 0: too few for a fit
    double floor = 0.0;              ///< error that more effort does not reduce; 0: not reached
    double floorFrom = 0.0;          ///< effort from which on the error stays at the floor
};

/// Fits the order by least squares on log scales. First finds the longest sequence of falling errors (each at
/// least 15 % below the previous one). Then fits the longest part of the sequence with points within 25 % of
/// a straight line; without such a part, the whole sequence, except its last point if a floor follows; if no
/// error falls, fits all points. The points after the sequence are the floor. Ignores errors of 0 and
/// non-finite errors.
/// @param samples  sorted by increasing effort
Order orderOf(std::span<const Sample> samples);

/// Returns the indices of the samples that no other sample beats in both effort and error, by increasing
/// effort. Improvements of less than 1 % are ignored.
std::vector<std::size_t> paretoFront(std::span<const Sample> samples);

}  // namespace plumb::accuracy
