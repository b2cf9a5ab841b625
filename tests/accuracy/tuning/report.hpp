#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/tuning/sweep.hpp"

namespace plumb::tuning {

/// Explains why a change of a constant changes a family's success rate by more than 2 %; empty for others.
std::string_view reasonOf(std::string_view constant);
/// True if a change of the constant changes a success rate by more than 2 % and more than random variation.
bool needsReason(const std::vector<Trial>& trials, const Constant& constant);

std::string textOf(const Trial& trial);
std::string csvOf(const std::vector<Trial>& trials);
/// @param how  the command that produced the results
std::string htmlOf(const std::vector<Trial>& trials, const std::string& how);
std::string markdownOf(const std::vector<Trial>& trials, const std::string& how);

}  // namespace plumb::tuning
