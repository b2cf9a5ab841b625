#include "codec/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNone = 255;

constexpr std::array<std::uint8_t, 256> kValues = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(kNone);
    for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
        values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}();

std::uint32_t valueOf(char digit) { return kValues[static_cast<unsigned char>(digit)]; }

constexpr bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

Error brokenText(std::string_view where, std::string what) {
    return Error{std::string{where}, std::move(what),
                 "export the file again; base64 text is damaged easily by editors"};
}

std::string withoutSpace(std::string_view text) {
    std::string kept;
    kept.reserve(text.size());
    std::copy_if(text.begin(), text.end(), std::back_inserter(kept), [](char c) { return !isSpace(c); });
    return kept;
}

/// Decodes digits without white space and padding.
Result<std::string> decode(std::string_view digits, std::string_view where) {
    const std::size_t rest = digits.size() % 4;
    if (rest == 1) return brokenText(where, "the base64 text has an invalid length");
    std::string bytes(digits.size() / 4 * 3 + (rest == 0 ? 0 : rest - 1), '\0');
    std::size_t out = 0;
    std::uint32_t seen = 0;  // an invalid digit sets its high bits, which are checked after the loop
    for (std::size_t at = 0; at < digits.size(); at += 4) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t value = at + i < digits.size() ? valueOf(digits[at + i]) : 0u;
            seen |= value;
            bits = bits << 6 | (value & 63);
        }
        for (int shift = 16; shift >= 0 && out < bytes.size(); shift -= 8) {
            bytes[out++] = static_cast<char>(bits >> shift & 255);
        }
    }
    if (seen < 64) return bytes;
    const auto wrong = std::find_if(digits.begin(), digits.end(), [](char c) { return valueOf(c) == kNone; });
    return brokenText(where, *wrong == '='
                                 ? std::string{"the base64 text continues after its padding"}
                                 : format("character {} is not a base64 digit", wrong - digits.begin() + 1));
}

}  // namespace

Result<std::string> bytesFromBase64(std::string_view text, std::string_view where) {
    const bool isSpaced = std::any_of(text.begin(), text.end(), isSpace);
    const std::string kept = isSpaced ? withoutSpace(text) : std::string{};
    std::string_view digits = isSpaced ? std::string_view{kept} : text;
    for (int padding = 0; padding < 2 && !digits.empty() && digits.back() == '='; ++padding)
        digits.remove_suffix(1);
    return decode(digits, where);
}

std::string toBase64(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    char* out = text.data();
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            three = three << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        }
        for (std::size_t i = 0; i <= count; ++i) out[i] = kAlphabet[three >> (18 - 6 * i) & 63];
        out += 4;
    }
    return text;
}

Result<std::string> bytesFromBase64Url(std::string_view text, std::string_view where) {
    const std::size_t foreign = text.find_first_of("+/=");
    if (foreign != std::string_view::npos)
        return brokenText(where, format("character {} is not a base64url digit", foreign + 1));
    std::string digits{text};
    std::replace(digits.begin(), digits.end(), '-', '+');
    std::replace(digits.begin(), digits.end(), '_', '/');
    return bytesFromBase64(digits, where);
}

std::string toBase64Url(std::string_view bytes) {
    std::string text = toBase64(bytes);
    while (!text.empty() && text.back() == '=') text.pop_back();
    std::replace(text.begin(), text.end(), '+', '-');
    std::replace(text.begin(), text.end(), '/', '_');
    return text;
}

}  // namespace plumb
