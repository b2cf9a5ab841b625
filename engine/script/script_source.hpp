#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Name of the variable that counts down in prepared scripts, and of the function that is called when it is
/// below 0. Both are local variables outside of the script; the first is the first upvalue of its function.
inline constexpr std::string_view kBudget = "__budget";
inline constexpr std::string_view kOverBudget = "__overBudget";
/// Name of a local variable of scripts that have functions with `...`.
inline constexpr std::string_view kVarargCount = "__count";

/// Prepares the text of a script for loading. In front of each round of a loop, each call of a function and
/// each goto it counts down a budget, so that a script that never ends is stopped, after the same number of
/// rounds on every machine. (A hook of Lua that counts instructions makes scripts four times slower, this at
/// most twice.) A function with more than 250 values in its `...` is stopped as well. Lines keep their
/// numbers.
/// @param name  of the file, for errors
/// @error text that is not UTF-8; a power `x^y` whose exponent is not 2: pow() of the C library differs
/// between
///        machines; the two names above, "__count" or "__mode"; "__call", unless it is in a
///        constructor of a table or names a function that is defined or called; an "end" or "until" that closes nothing,
///        which would end the function around the script
Result<std::string> prepareScript(std::string_view text, std::string_view name);

}  // namespace plumb
