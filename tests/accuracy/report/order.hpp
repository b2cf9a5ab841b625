#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plumb::accuracy {

/// A point of a work-precision plot.
struct Sample {
    double effort = 0.0;  ///< substeps, or µs per step
    double error = 0.0;
};

/// The exponent p of error ~ 1 / effort^p, and its range of validity.
struct Order {
    double power = 0.0;
    double first = 0.0, last = 0.0;  ///< effort: of the fitted points
    int points = 0;                  ///< 0: too few for a fit
    double floor = 0.0;              ///< the error that more effort does not reduce; 0 if none was reached
    double floorFrom = 0.0;          ///< effort from which on it holds
};

/// Fits a straight line by least squares, on log scales, to the longest part of the longest sequence of
/// falling points (each at least 15 % better than the previous one) that is within a quarter of such a line.
/// If there is none, it uses the whole sequence, without the last point if a floor follows; and if nothing
/// falls, all points. The points after the sequence are the floor. Points with an error of 0 or NaN are
/// omitted.
/// @param samples by increasing effort
Order orderOf(std::span<const Sample> samples);

/// Indices of the samples that no other beats in both effort and error,
/// by increasing effort; improvements of less than 1 % are omitted.
std::vector<std::size_t> paretoFront(std::span<const Sample> samples);

}  // namespace plumb::accuracy
