#pragma once

#include <span>
#include <string_view>

namespace plumb::stability {

/// `./plumb accuracy --stability`: runs the stability map with progress output, and writes
/// stability.csv, stability.json and stability.html. The options are in its --help.
/// @param words the arguments after --stability
/// @return an exit code: 1 if a cell blows up or a file cannot be written, 2 for invalid arguments
int runStability(std::span<const std::string_view> words);

}  // namespace plumb::stability
