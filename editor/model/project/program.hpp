#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
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

/// Runs a program in the same way, and can end it. It has no terminal, so that nothing waits there for an
/// answer.
/// @param heard  called with each piece of the text as it is printed, on this thread
/// @param stop   ends the program with all that it has started; Windows waits for its end
ProgramEnd runProgram(const std::vector<std::string>& words,
                      const std::function<void(std::string_view)>& heard, const std::stop_token& stop);

/// Starts a program in the same way and does not wait for it.
/// @error  there is no such program, or it cannot be started
Result<Done> startProgram(const std::vector<std::string>& words);

}  // namespace plumb::editor
