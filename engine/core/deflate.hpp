#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace plumb {

/// Packs words, least significant byte first, into a zlib stream (RFC 1950).
/// Optimized for grids of tiles: matches are searched at whole words only, many times
/// faster than at each byte. The same words give the same bytes on every machine.
std::string packZlib(std::span<const std::uint32_t> words);

}  // namespace plumb
