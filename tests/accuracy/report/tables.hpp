#pragma once

#include <span>
#include <string>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// A line for each row, under a line of names; commas and quotes in words are made harmless.
std::string csvOf(std::span<const Row> rows);

/// [{scene, figure, solver, integrator, substeps, iterations, error, unit, usPerStep, …}]. What is no number
/// (a scene that came apart, no target) is null.
std::string jsonOf(std::span<const Row> rows);

}  // namespace plumb::accuracy
