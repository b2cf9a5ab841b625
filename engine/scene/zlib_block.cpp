#include "scene/zlib_block.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cstring>
#include <optional>

// stb's zlib, private to this file: the pictures of other layers have their own.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "core/deflate.hpp"

namespace plumb {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<std::uint8_t, 256> digitValues() {
    std::array<std::uint8_t, 256> values{};
    values.fill(0xff);
    for (std::size_t i = 0; i < kDigits.size(); ++i) {
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
    }
    return values;
}

std::string base64Of(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    char* out = text.data();
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            three = three << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        }
        for (std::size_t i = 0; i <= count; ++i) out[i] = kDigits[three >> (18 - 6 * i) & 63];
        out += 4;
    }
    return text;
}

std::optional<std::string> bytesOf(std::string_view text) {
    static constexpr std::array<std::uint8_t, 256> kValues = digitValues();
    if (text.size() % 4 != 0) return std::nullopt;
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    const auto valueAt = [&text](std::size_t at) { return kValues[static_cast<unsigned char>(text[at])]; };
    std::string bytes(text.size() * 3 / 4, '\0');
    char* out = bytes.data();
    unsigned seen = 0;  // wrong letters are 0xff: looked for once, at the end
    std::size_t at = 0;
    for (; at + 4 <= text.size(); at += 4) {
        const unsigned a = valueAt(at), b = valueAt(at + 1), c = valueAt(at + 2), d = valueAt(at + 3);
        seen |= a | b | c | d;
        *out++ = static_cast<char>(a << 2 | b >> 4);
        *out++ = static_cast<char>(b << 4 | c >> 2);
        *out++ = static_cast<char>(c << 6 | d);
    }
    // Two or three letters may be left: one or two bytes.
    unsigned rest = 0;
    const std::size_t left = text.size() - at;
    for (std::size_t i = 0; i < left; ++i) {
        seen |= valueAt(at + i);
        rest |= unsigned{valueAt(at + i)} << (18 - 6 * i);
    }
    for (std::size_t i = 0; i + 1 < left; ++i) *out++ = static_cast<char>(rest >> (16 - 8 * i));
    if (seen > 63 || left == 1) return std::nullopt;
    return bytes;
}

/// Words in memory order to words least byte first, and back.
std::uint32_t leastFirst(std::uint32_t word) {
    if constexpr (std::endian::native == std::endian::little) return word;
    return word << 24 | (word & 0xff00) << 8 | (word >> 8 & 0xff00) | word >> 24;
}

}  // namespace

std::string packedText(std::span<const std::uint32_t> words) { return base64Of(packZlib(words)); }

bool unpackText(std::string_view text, std::span<std::uint32_t> words) {
    const std::optional<std::string> packed = bytesOf(text);
    if (!packed || packed->size() > INT_MAX || words.size_bytes() > INT_MAX) return false;
    // The decoder stops at the end of the room it is given: a bomb cannot grow past the size that was
    // declared.
    const int size =
        stbi_zlib_decode_buffer(reinterpret_cast<char*>(words.data()), static_cast<int>(words.size_bytes()),
                                packed->data(), static_cast<int>(packed->size()));
    for (std::uint32_t& word : words) word = leastFirst(word);
    return size >= 0 && static_cast<std::size_t>(size) == words.size_bytes();
}

}  // namespace plumb
