#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace plumb {

/// Stamps of the chunks in a block of tiles, in row-major order; 0 for missing chunks.
using BlockStamps = std::array<std::uint64_t, 16>;

/// Caches the file text of a block of tiles, from reading or packing it. Every change of a chunk gets a new
/// unique stamp, so the text is valid for every block with these stamps: in the world, in a copy of it, after
/// undo. Unchanged blocks are thus saved with the same bytes as in the file, without packing them again.
///
/// The cache is global and thread-safe. Texts that were not used recently are dropped.

void rememberTileText(const BlockStamps& stamps, const std::string& text);
/// Returns the cached text of a block; nullopt if there is none.
[[nodiscard]] std::optional<std::string> knownTileText(const BlockStamps& stamps);

}  // namespace plumb
