#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace plumb::editor {

/// Result of matching a typed text against an entry.
struct FuzzyMatch {
    int score = 0;                  ///< higher is better; comparable only for the same typed text
    std::vector<std::uint32_t> at;  ///< indices of the matched bytes of the text, ascending
};

/// Matches the letters of each typed word in order, but not necessarily adjacent, ignoring case: "ocr"
/// matches "One cell right". Adjacent letters and those at the start of a word score higher, distant ones
/// lower. Words may match in any order. Deterministic.
/// @param name  index in the text at which the name begins; letters from there on score higher
/// @return nullopt if a letter is missing
std::optional<FuzzyMatch> fuzzyMatch(std::string_view typed, std::string_view text, std::size_t name = 0);

}  // namespace plumb::editor
