#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/tuning/sweep.hpp"

namespace plumb::tuning {

/// Explanations for the constants that change a share by more than 2 %; empty for the others.
std::string_view reasonOf(std::string_view constant);
/// True if some share changes by more than chance explains.
bool needsReason(const std::vector<Trial>& trials, const Constant& constant);

std::string textOf(const Trial& trial);
std::string csvOf(const std::vector<Trial>& trials);
/// @param how  the command
std::string htmlOf(const std::vector<Trial>& trials, const std::string& how);
std::string markdownOf(const std::vector<Trial>& trials, const std::string& how);

}  // namespace plumb::tuning
