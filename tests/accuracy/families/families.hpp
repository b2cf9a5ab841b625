#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "tests/bench/physics/measure.hpp"

namespace plumb::families {

/// Runs the command ./plumb accuracy --families N ….
/// @param words  command-line arguments after --families
/// @param peers  other engines to compare with
/// @param out    default folder of families.csv and families.html
/// @return the exit code: 0 if every relation holds in every family
int runFamilyCommand(std::span<const std::string_view> words, std::vector<scenes::Engine> peers,
                     const Path& out);

}  // namespace plumb::families
