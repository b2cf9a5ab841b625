#include "scene/files/zlib_block.hpp"

#include <bit>
#include <cstring>

#include "codec/base64.hpp"
#include "codec/compression.hpp"

namespace plumb {
namespace {

/// Converts between native and little-endian byte order.
std::uint32_t lowestFirst(std::uint32_t word) {
    if constexpr (std::endian::native == std::endian::little) return word;
    return word << 24 | (word & 0xff00) << 8 | (word >> 8 & 0xff00) | word >> 24;
}

}  // namespace

std::string packedText(std::span<const std::uint32_t> words) {
    std::string bytes(words.size_bytes(), '\0');
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::uint32_t word = lowestFirst(words[i]);
        std::memcpy(bytes.data() + i * sizeof word, &word, sizeof word);
    }
    return toBase64(packZlib(bytes));
}

bool unpackText(std::string_view text, std::span<std::uint32_t> words) {
    const Result<std::string> packed = bytesFromBase64(text, "");
    if (!packed) return false;
    const Result<std::string> bytes = unpackZlib(*packed, words.size_bytes(), "");
    if (!bytes || bytes->size() != words.size_bytes()) return false;
    std::memcpy(words.data(), bytes->data(), bytes->size());
    for (std::uint32_t& word : words) word = lowestFirst(word);
    return true;
}

}  // namespace plumb
