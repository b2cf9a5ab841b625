#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace plumb::editor {

/// How well a text matches what was typed.
struct FuzzyMatch {
    int score = 0;                  ///< more is better; only comparable for the same words typed
    std::vector<std::uint32_t> at;  ///< the bytes of the text that were meant, ascending
};

/// Finds the letters of each typed word in the text, in their order but not side by side, in any case: "ocr"
/// finds "One cell right". Letters at the beginning of a word and side by side count more, those that are far
/// apart less. Words may come in any order. The same for the same texts, always.
/// @param name  where in the text its name begins: letters from there on count more
/// @return nothing when a letter is missing
std::optional<FuzzyMatch> fuzzyMatch(std::string_view typed, std::string_view text, std::size_t name = 0);

}  // namespace plumb::editor
