#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plumb::accuracy {

/// One point of a work-precision plot.
struct Sample {
    double effort = 0.0;  ///< substeps, or µs a step
    double error = 0.0;
};

/// The p of error ~ 1 / effort^p, and down to where it holds.
struct Order {
    double power = 0.0;
    double first = 0.0, last = 0.0;  ///< effort: of the points it was fitted to
    int points = 0;                  ///< 0: too few to tell
    double floor = 0.0;              ///< the error that more effort does not get below; 0 where none was met
    double floorFrom = 0.0;          ///< effort from which on
};

/// Fits a straight line by least squares, on log scales, to the longest part of the longest row of falling
/// points (each at least 15 % better than the one before) that is within a quarter of such a line. Where
/// there is none it takes the whole row, without the last point if a floor follows; and where nothing falls,
/// all. What follows the row is the floor. Points whose error is 0 or no number are left out.
/// @param samples  by growing effort
Order orderOf(std::span<const Sample> samples);

/// Indices of the samples that no other beats in both effort and error, by growing effort; one that is better
/// than the one before by less than 1 % is left out.
std::vector<std::size_t> paretoFront(std::span<const Sample> samples);

}  // namespace plumb::accuracy
