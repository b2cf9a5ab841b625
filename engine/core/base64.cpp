#include "core/base64.hpp"

#include <array>
#include <cstdint>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNone = 255;

constexpr std::array<std::uint8_t, 256> kValues = [] {
    std::array<std::uint8_t, 256> values{};
    for (std::uint8_t& value : values) value = kNone;
    for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
        values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}();

constexpr bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

Error brokenText(std::string_view where, std::string what) {
    return Error{std::string{where}, std::move(what),
                 "export the file again; base64 text is damaged easily by editors"};
}

}  // namespace

Result<std::string> bytesFromBase64(std::string_view text, std::string_view where) {
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int digits = 0;
    int padding = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (isSpace(text[at])) continue;
        if (text[at] == '=') {
            ++padding;
            continue;
        }
        const std::uint8_t value = kValues[static_cast<unsigned char>(text[at])];
        if (value == kNone) return brokenText(where, format("character {} is not base64", at + 1));
        if (padding > 0) return brokenText(where, "base64 text goes on after its end");
        bits = bits << 6 | value;
        if (++digits == 4) {
            bytes += {static_cast<char>(bits >> 16 & 255), static_cast<char>(bits >> 8 & 255),
                      static_cast<char>(bits & 255)};
            digits = 0, bits = 0;
        }
    }
    if (digits == 1 || padding > 2) return brokenText(where, "base64 text of an impossible length");
    if (digits == 2) bytes += static_cast<char>(bits >> 4 & 255);
    if (digits == 3) bytes += {static_cast<char>(bits >> 10 & 255), static_cast<char>(bits >> 2 & 255)};
    return bytes;
}

std::string toBase64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            bits = bits << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        }
        const std::size_t count = bytes.size() - at < 3 ? bytes.size() - at : 3;
        for (std::size_t i = 0; i < 4; ++i) {
            text += i <= count ? kAlphabet[bits >> (18 - 6 * i) & 63] : '=';
        }
    }
    return text;
}

}  // namespace plumb
