#pragma once

#include <span>
#include <string>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// Returns a CSV table with a header line; commas and quotes in texts are escaped.
std::string csvOf(std::span<const Row> rows);

/// Returns a JSON array of objects {scene, figure, solver, integrator, substeps, iterations, error, unit,
/// usPerStep, …}. Non-finite numbers (diverged simulations, no goal) are null.
std::string jsonOf(std::span<const Row> rows);

}  // namespace plumb::accuracy
