#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace plumb::accuracy {

/// A command-line option without value, and the variable that it sets to true.
struct Flag {
    std::string_view word;
    bool* on;  ///< set to true if the option is given
};

/// Callback that parses the value of an option. @return the error message; empty: success
using TakeOption = std::function<std::string(std::string_view word, std::string_view value)>;

/// Parses flags, and options with one value each. @return the error message; empty: success
std::string readWords(std::span<const std::string_view> words, std::span<const Flag> flags,
                      const TakeOption& take);

/// Error message of a TakeOption for an unknown option.
inline constexpr const char* kUnknownWord = "unknown option";

/// Parses an integer from 1 to `most`. @return the error message; empty: success
std::string readCount(std::string_view value, int most, int& count);

}  // namespace plumb::accuracy
