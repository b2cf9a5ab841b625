#pragma once

#include <span>
#include <string_view>

namespace plumb::stability {

/// `./plumb accuracy --stability`: plays the stability map, says on the way how far it is, and writes
/// stability.csv, stability.json and stability.html. The options are in its --help.
/// @param words  the command line behind --stability
/// @return       an exit code: 1 where a cell blows up or a file cannot be written, 2 for a bad command line
int runStability(std::span<const std::string_view> words);

}  // namespace plumb::stability
