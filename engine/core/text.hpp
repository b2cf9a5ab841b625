#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// An argument of `format`, converted to text.
struct FormatArgument {
    FormatArgument(std::string_view value) : text{value} {}
    FormatArgument(const std::string& value) : text{value} {}
    FormatArgument(const char* value) : text{value != nullptr ? value : "(null)"} {}
    FormatArgument(char value) : text(1, value) {}
    FormatArgument(bool value) : text{value ? "true" : "false"} {}
    FormatArgument(int value);
    FormatArgument(unsigned value);
    FormatArgument(long value);
    FormatArgument(unsigned long value);
    FormatArgument(long long value);
    FormatArgument(unsigned long long value);
    FormatArgument(float value);
    FormatArgument(double value);

    std::string text;
};

/// Replaces each `{}` of the pattern by the next argument. Where there are fewer
/// arguments the rest of the pattern stays as it is; where there are more, the rest of them is not used.
std::string formatArguments(std::string_view pattern, std::span<const FormatArgument> arguments);

/// A pattern of format() that is known only at run time, e.g. from a file. Its `{}` are not counted: see
/// formatArguments().
struct RuntimePattern {
    std::string_view text;
};
[[nodiscard]] constexpr RuntimePattern runtimePattern(std::string_view text) { return {text}; }

/// Number of `{}` in a pattern.
constexpr std::size_t placeholdersIn(std::string_view pattern) {
    std::size_t count = 0;
    for (std::size_t at = pattern.find("{}"); at != std::string_view::npos; at = pattern.find("{}", at + 2))
        ++count;
    return count;
}

/// Not constexpr, and never defined: a compiler that reports a call of it reports a pattern of format(),
/// logNote() or logWarning() with more or fewer `{}` than arguments follow. `{}` has no options:
/// fixedText(value, 2) writes two decimals.
void theNumberOfPlaceholdersDiffersFromTheNumberOfArguments();

/// A pattern with one `{}` for each of kArguments arguments, which is checked while compiling. A pattern
/// that is not a constant is given as runtimePattern(text).
template <std::size_t kArguments>
struct FormatPattern {
    template <class Text>
    requires std::convertible_to<const Text&, std::string_view>
    consteval FormatPattern(const Text& pattern) : text{pattern} {
        if (placeholdersIn(text) != kArguments) theNumberOfPlaceholdersDiffersFromTheNumberOfArguments();
    }
    constexpr FormatPattern(RuntimePattern pattern) : text{pattern.text} {}

    std::string_view text;
};

/// Replaces each `{}` of the pattern by the next argument: texts, numbers and bools.
template <class... Arguments>
std::string format(FormatPattern<sizeof...(Arguments)> pattern, const Arguments&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
        return formatArguments(pattern.text, {});
    } else {
        const FormatArgument list[] = {FormatArgument{arguments}...};
        return formatArguments(pattern.text, list);
    }
}

/// The shortest decimal text that is read back as the same bits ("0.1", "1e+20", "-3").
std::string shortestText(float value);
std::string shortestText(double value);

/// Decimal text with a fixed number of digits after the point, for display.
std::string fixedText(double value, int digits);

/// 16 lower-case hex digits, and the inverse function, which accepts 1..16 hex digits.
std::string hexText(std::uint64_t value);
std::optional<std::uint64_t> parseHex(std::string_view text);

/// The whole text as a number, in the C locale; nothing if it contains anything else.
std::optional<float> parseFloat(std::string_view text);
std::optional<std::int64_t> parseInt(std::string_view text);

std::vector<std::string_view> split(std::string_view text, char separator);
std::string_view trimmed(std::string_view text);
bool startsWith(std::string_view text, std::string_view start);
bool endsWith(std::string_view text, std::string_view end);
bool isUtf8(std::string_view text);

/// The candidate closest to a mistyped word, for "did you mean"; empty if none is close.
std::string_view closestName(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace plumb
