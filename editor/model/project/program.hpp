#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace plumb::editor {

/// What a program printed on both outputs, and whether it ended with 0.
struct ProgramEnd {
    bool succeeded = false;
    std::string text;
};

/// Runs a program and waits for its end. No shell takes part: each word reaches the program unchanged.
/// @param words  the program, searched in PATH if it names no folder, and its arguments
ProgramEnd runProgram(const std::vector<std::string>& words);

/// Starts a program in the same way and does not wait for it.
/// @error  there is no such program, or it cannot be started
Result<Done> startProgram(const std::vector<std::string>& words);

}  // namespace plumb::editor
