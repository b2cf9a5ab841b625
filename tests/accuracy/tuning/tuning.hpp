#pragma once

#include <span>
#include <string_view>

#include "core/file.hpp"

namespace plumb::tuning {

/// ./plumb accuracy --tuning …; `words` are the arguments after --tuning.
/// @param out folder of tuning.csv and tuning.html, unless the arguments name another
/// @return an exit code: 0 if every changed share has its explanation
int runTuningCommand(std::span<const std::string_view> words, const Path& out);

}  // namespace plumb::tuning
