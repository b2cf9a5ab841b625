#pragma once

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
    FormatArgument(const char* value) : text{value} {}
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

std::string formatArguments(std::string_view pattern, std::span<const FormatArgument> arguments);

/// Replaces each `{}` of the pattern by the next argument.
template <class... Arguments>
std::string format(std::string_view pattern, const Arguments&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
        return formatArguments(pattern, {});
    } else {
        const FormatArgument list[] = {FormatArgument{arguments}...};
        return formatArguments(pattern, list);
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
