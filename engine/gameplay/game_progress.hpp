#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/fixed_list.hpp"
#include "core/hash.hpp"
#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

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
    /// For saved games: a later version keeps the fields that stay.
    static void describe(TypeBuilder<GameProgress>& type) {
        type.name("GameProgress").doc("The progress of the player.");
        type.field<&GameProgress::coins>("coins");
        type.field<&GameProgress::coinsTotal>("coinsTotal");
        type.field<&GameProgress::levelCoins>("levelCoins");
        type.field<&GameProgress::levelCoinsTotal>("levelCoinsTotal");
        type.field<&GameProgress::keys>("keys");
        type.field<&GameProgress::deaths>("deaths");
        type.field<&GameProgress::ticks>("ticks");
        type.field<&GameProgress::level>("level");
        type.field<&GameProgress::levelsReached>("levelsReached");
        type.field<&GameProgress::levelFinished>("levelFinished");
        type.field<&GameProgress::gameFinished>("gameFinished");
    }
};

/// Replaces the {words} in the text of a Label by their values: those of LabelValues; of GameProgress
/// {coins}, {coinsTotal}, {levelCoins}, {levelCoinsTotal}, {keys}, {deaths}, {time} (m:ss), {level} (number
/// of levels entered) and {levelName}; {health} of the player; {key:Jump}, the key of an action or the keys
/// of an axis, as the player has them now (appendKey); counts of the physics in the last tick:
/// {bodies}, {contacts}, {joints}, and of its stages {pairs}, {circles}, {boxes}, {axes}, {kept}, {touching}.
/// Other words stay as they are.
/// @param out  receives the text; passing the same string again avoids allocations
void fillPlaceholders(const World& world, std::string_view text, std::string& out);

}  // namespace plumb
