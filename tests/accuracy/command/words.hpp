#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace plumb::accuracy {

/// A flag of a command line, and the value that it sets.
struct Flag {
    std::string_view word;
    bool* on;
};

/// Parses an option with a value. @return the error; empty if none
using TakeOption = std::function<std::string(std::string_view word, std::string_view value)>;

/// Parses flags, and options with one value each. @return the error; empty if none
std::string readWords(std::span<const std::string_view> words, std::span<const Flag> flags,
                      const TakeOption& take);

/// Result of a TakeOption for an unknown option.
inline constexpr const char* kUnknownWord = "unknown option";

/// Parses an integer from 1. @return the error; empty if none
std::string readCount(std::string_view value, int most, int& count);

}  // namespace plumb::accuracy
