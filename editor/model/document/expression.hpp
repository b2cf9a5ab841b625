#pragma once

#include <span>
#include <string_view>

#include "core/result.hpp"

namespace plumb::editor {

/// A named value that an expression may use.
struct NamedNumber {
    std::string_view name;
    double value = 0.0;
};

/// Evaluates an arithmetic expression: `16*3+4`, `2^8`, `sqrt(2)/2`, `max(16, pi)`. Supports decimal numbers,
/// + - * / % ^, parentheses, pi, tau, and the functions listed by `expressionFunctions`.
/// @param known  named values besides pi and tau
/// @error        "column N" (from 1) with the token expected and the one found
Result<double> evaluate(std::string_view text, std::span<const NamedNumber> known = {});

/// Returns the names of all functions for help and messages: "sqrt, abs, …".
std::string expressionFunctions();

/// One of several numbers that are changed by one typed text.
struct TypedOver {
    double value = 0.0;     ///< present value
    std::size_t index = 0;  ///< index of the number among those that change, from 0
    std::size_t count = 1;  ///< count of numbers that change
};

/// Returns the new value of a number from a typed text: an expression, or an operation on the present value
/// (`+=10`, `-=10`, `*=2`, `/=2`, `*2`, `/2`). x, i and n are the present value, the index and the count of
/// the numbers, so `16*i` places entities in a row.
/// @error  as `evaluate`; columns count from the start of the whole text
Result<double> typedNumber(std::string_view text, const TypedOver& old);

}  // namespace plumb::editor
