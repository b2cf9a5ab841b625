#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// Returns accuracy.html: all diagrams with explanations, self-contained.
/// @param how description of the run
std::string pageOf(const std::vector<Row>& rows, std::string_view how);

}  // namespace plumb::accuracy
