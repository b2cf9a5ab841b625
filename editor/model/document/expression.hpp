#pragma once

#include <span>
#include <string_view>

#include "core/result.hpp"

namespace plumb::editor {

/// A word that stands for a number in an expression.
struct NamedNumber {
    std::string_view name;
    double value = 0.0;
};

/// Works out what a person typed: `16*3+4`, `2^8`, `sqrt(2)/2`, `max(16, pi)`. It reads numbers with a point,
/// + - * / % ^, parentheses, pi, tau, and the functions of `expressionFunctions`.
/// @param known  more words, beside pi and tau
/// @error        where is "column N", counted from 1; what was expected and what stands there
Result<double> evaluate(std::string_view text, std::span<const NamedNumber> known = {});

/// "sqrt, abs, …": for help and for messages.
std::string expressionFunctions();

/// One of several numbers that a person changes by typing once.
struct TypedOver {
    double value = 0.0;     ///< what it is now
    std::size_t index = 0;  ///< its place among those that change, from 0
    std::size_t count = 1;  ///< how many change
};

/// What a number becomes by what was typed over it: an expression, or `+=10`, `-=10`, `*=2`, `/=2`, `*2`,
/// `/2` for what it was, changed. The words x, i and n stand for what it is, its place, and how many there
/// are, so that `16*i` lines things up.
/// @error  as evaluate; the column counts in the whole text
Result<double> typedNumber(std::string_view text, const TypedOver& old);

}  // namespace plumb::editor
