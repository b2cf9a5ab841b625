#pragma once

#include <span>
#include <string>

#include "tests/bench/physics/measure.hpp"

namespace plumb::scenes {

void printMeasurementHeader();
/// The rows of one scene; the last column is the time of each over that of the first with as many threads.
void printMeasurements(std::span<const Measurement> rows);

/// The p of cost ~ n^p, by least squares over the logarithms of rows that differ in size only.
double exponentOf(std::span<const Measurement> rows);
/// One line for each engine with each family of scenes that differ in size.
void printExponents(std::span<const Measurement> rows);

/// As JSON: {scene, engine, threads, msPerStep, …}. @return false when it could not
bool writeMeasurements(const std::string& path, std::span<const Measurement> rows);

}  // namespace plumb::scenes
