#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// accuracy.html: all plots with what they mean, complete in itself.
/// @param how  in words, how the rows came to be
std::string pageOf(const std::vector<Row>& rows, std::string_view how);

}  // namespace plumb::accuracy
