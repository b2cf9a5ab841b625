#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace plumb {

/// Packs words, least byte first, into a zlib stream (RFC 1950) that every reader of zlib unpacks. Made for
/// grids of tiles: what repeats is looked for at whole words only, which is many times faster than to look at
/// each byte. The same words become the same bytes on every machine.
std::string packZlib(std::span<const std::uint32_t> words);

}  // namespace plumb
