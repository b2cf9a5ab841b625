#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace plumb::accuracy {

/// A word of a command line that stands alone, and what it switches on.
struct Flag {
    std::string_view word;
    bool* on;
};

/// Takes a word and its value. @return what is wrong; empty if nothing
using TakeOption = std::function<std::string(std::string_view word, std::string_view value)>;

/// Reads flags, and words with a value each. @return what is wrong; empty if nothing
std::string readWords(std::span<const std::string_view> words, std::span<const Flag> flags,
                      const TakeOption& take);

/// What a TakeOption says of a word that it does not know.
inline constexpr const char* kUnknownWord = "unknown option";

/// Reads a whole number from 1. @return what is wrong; empty if nothing
std::string readCount(std::string_view value, int most, int& count);

}  // namespace plumb::accuracy
