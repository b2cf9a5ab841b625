#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace plumb {

/// The stamps of the chunks of a block of tiles, rows first; 0 for a chunk that is not there.
using BlockStamps = std::array<std::uint64_t, 16>;

/// How files have blocks of tiles: the text that a block was read from, or packed into. No two changes of the
/// program share a stamp, so a text is right for every block with these stamps: the world it was read
/// into, a copy of that in another thread, a step that was undone. So what was not changed is written with
/// the very bytes that the file had, and is not packed again.
///
/// One for the whole program, for any thread. Texts that were not asked for lately are dropped.

void rememberTileText(const BlockStamps& stamps, const std::string& text);
/// Nothing when it is not known.
[[nodiscard]] std::optional<std::string> knownTileText(const BlockStamps& stamps);

}  // namespace plumb
