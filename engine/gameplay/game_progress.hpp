#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/fixed_list.hpp"
#include "core/hash.hpp"
#include "core/text_store.hpp"

namespace plumb {

class World;

/// What the player has achieved. A resource; it outlives scene changes and is part of snapshots and the hash.
struct GameProgress {
    static constexpr std::size_t kMostLevels = 64;

    int coins = 0;            ///< in the whole game
    int coinsTotal = 0;       ///< coins that the levels entered so far hold
    int levelCoins = 0;       ///< in this level
    int levelCoinsTotal = 0;  ///< that this level holds
    int keys = 0;             ///< held now
    int deaths = 0;
    std::uint64_t ticks = 0;                       ///< played in levels, 60 a second
    TextId level;                                  ///< path of the scene that the player is in
    FixedList<TextId, kMostLevels> levelsReached;  ///< paths of scenes with a player, in order of arrival
    bool levelFinished = false;                    ///< the goal was touched
    bool gameFinished = false;                     ///< and nothing but titles follows

    void addTo(Hasher& hasher) const;
};

/// Puts what the player has achieved in place of {coins}, {coinsTotal}, {levelCoins}, {levelCoinsTotal},
/// {keys}, {deaths}, {time} (m:ss), {level} (its number), {levelName} and {health}; other braces stay.
/// @param out  the filled text; its memory is used again
void fillPlaceholders(const World& world, std::string_view text, std::string& out);

}  // namespace plumb
