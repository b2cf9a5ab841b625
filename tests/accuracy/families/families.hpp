#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tests/bench/physics/measure.hpp"

namespace plumb::families {

/// ./plumb accuracy --families N …; `words` are those behind --families.
/// @param peers  other engines to compare with
/// @return an exit code: 0 if every relation holds in every family
int runFamilyCommand(std::span<const std::string_view> words, std::vector<scenes::Engine> peers);

}  // namespace plumb::families
