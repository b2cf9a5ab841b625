#pragma once

#include <span>
#include <string_view>

#include "core/file.hpp"

namespace plumb::tuning {

/// Runs the command ./plumb accuracy --tuning ….
/// @param words  arguments after --tuning
/// @param out    default folder of tuning.csv and tuning.html
/// @return the exit code: 0 if reasons.cpp explains each constant that changes a family's success rate
int runTuningCommand(std::span<const std::string_view> words, const Path& out);

}  // namespace plumb::tuning
