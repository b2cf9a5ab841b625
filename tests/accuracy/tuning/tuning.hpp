#pragma once

#include <span>
#include <string_view>

#include "core/file.hpp"

namespace plumb::tuning {

/// ./plumb accuracy --tuning …; `words` are those behind --tuning.
/// @param out  folder of tuning.csv and tuning.html, unless the words name another
/// @return an exit code: 0 if every share that moves has its sentence
int runTuningCommand(std::span<const std::string_view> words, const Path& out);

}  // namespace plumb::tuning
