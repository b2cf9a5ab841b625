#pragma once

#include <span>
#include <string>

#include "tests/bench/physics/measure.hpp"

namespace plumb::scenes {

void printMeasurementHeader();
/// Prints the rows of one scene. The last column is the ratio of the time to that of the first valid row with
/// the same number of threads.
void printMeasurements(std::span<const Measurement> rows);

/// Returns the exponent p of cost ~ n^p, by a least-squares fit of the logarithms of rows that differ in size
/// only.
double exponentOf(std::span<const Measurement> rows);
/// Prints one line for each engine and each family of scenes that differ in size only.
void printExponents(std::span<const Measurement> rows);

/// Writes the rows as JSON: {scene, engine, threads, msPerStep, …}. @return false if that failed
bool writeMeasurements(const std::string& path, std::span<const Measurement> rows);

}  // namespace plumb::scenes
