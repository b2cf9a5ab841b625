#pragma once

#include <span>
#include <string>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// One line per row, after a header line; commas and quotes in texts are escaped.
std::string csvOf(std::span<const Row> rows);

/// [{scene, figure, solver, integrator, substeps, iterations, error, unit,
/// usPerStep, …}]. Non-finite numbers (a scene that fell apart, no goal) are null.
std::string jsonOf(std::span<const Row> rows);

}  // namespace plumb::accuracy
