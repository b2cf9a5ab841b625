#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// Returns little-endian words as zlib data in base64.
std::string packedText(std::span<const std::uint32_t> words);

/// Unpacks the result of packedText() into `words`.
/// @return false if the text is not base64, the data is damaged, or the number of words differs
bool unpackText(std::string_view text, std::span<std::uint32_t> words);

}  // namespace plumb
