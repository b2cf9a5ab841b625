#pragma once

#include <span>
#include <string_view>

namespace plumb::stability {

/// Runs the command `./plumb accuracy --stability`: simulates the stability map and writes stability.csv,
/// stability.json and stability.html. The options are documented in its --help.
/// @param words the arguments after --stability
/// @return the exit code: 0, 1 if a cell blows up or a file cannot be written, 2 for invalid arguments
int runStability(std::span<const std::string_view> words);

}  // namespace plumb::stability
