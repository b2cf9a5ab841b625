#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// Words, least byte first, as zlib data in base64.
std::string packedText(std::span<const std::uint32_t> words);

/// The way back into exactly that many words.
/// @return false when the text is no base64, the data is damaged, or holds another number of words
bool unpackText(std::string_view text, std::span<std::uint32_t> words);

}  // namespace plumb
