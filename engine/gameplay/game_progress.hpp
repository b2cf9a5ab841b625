#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/fixed_list.hpp"
#include "core/hash.hpp"
#include "core/text_store.hpp"

namespace plumb {

class World;

/// The player's progress. A world resource that survives scene changes and is included in snapshots and hash.
struct GameProgress {
    static constexpr std::size_t kMostLevels = 64;  ///< maximum number of levels that are remembered

    int coins = 0;                                 ///< coins collected in the whole game
    int coinsTotal = 0;                            ///< coins that exist in the levels entered so far
    int levelCoins = 0;                            ///< coins collected in this level
    int levelCoinsTotal = 0;                       ///< coins that exist in this level
    int keys = 0;                                  ///< keys that the player has
    int deaths = 0;                                ///< number of deaths of the player
    std::uint64_t ticks = 0;                       ///< ticks played in levels, 60 per second
    TextId level;                                  ///< path of the player's scene
    FixedList<TextId, kMostLevels> levelsReached;  ///< paths of entered levels, in order of entering
    bool levelFinished = false;                    ///< the goal of the level was touched
    bool gameFinished = false;                     ///< the goal of the last level was touched

    void addTo(Hasher& hasher) const;
};

/// Replaces placeholders in a text by values: {coins}, {coinsTotal}, {levelCoins}, {levelCoinsTotal}, {keys},
/// {deaths}, {time} (m:ss), {level} (number of levels entered), {levelName}, {health}, LabelValues and
/// physics counts. Unknown placeholders are kept.
/// @param out  receives the text; passing the same string again avoids allocations
void fillPlaceholders(const World& world, std::string_view text, std::string& out);

}  // namespace plumb
