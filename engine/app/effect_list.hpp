#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/effects.hpp"

namespace plumb {

class Game;
class Profile;

/// What of a tick is an effect's, by the names of the profiler.
struct EffectZones {
    std::vector<std::string_view> own;     ///< systems, and stages of the physics, that run for it alone
    std::vector<std::string_view> shared;  ///< stages that others need as well
};
EffectZones zonesOf(const EffectTable& table, std::size_t row);

/// Components of one kind that call for an effect.
struct EffectCount {
    const TypeInfo* type = nullptr;
    std::size_t count = 0;
};
/// What calls for an effect now, without the kinds of components that no entity has.
std::vector<EffectCount> callersOf(const World& world, const EffectRow& row);

/// The first kinds of components that could call for an effect.
std::string missingCallers(const EffectRow& row);

/// s that a zone of a profile takes by itself: to be taken from what it measured, once a call.
double zoneOverhead();

/// One effect of a world, for people.
struct EffectLine {
    std::size_t row = 0;
    bool calledFor = false;
    bool runs = false;
    Pin pin = Pin::Auto;
    std::string pinnedBy;  ///< path of a scene; empty: not pinned, or by the program
    std::vector<EffectCount> callers;
    EffectZones zones;
    double microseconds = 0.0;  ///< of a tick: its own zones
    double saves = 0.0;         ///< µs of a tick that are over without it; measured, so it may be below 0
};

/// All effects of a game, and what they cost.
struct EffectReport {
    const EffectTable* table = nullptr;
    int ticks = 0;              ///< that were measured; 0 for none
    double microseconds = 0.0;  ///< a whole tick
    std::vector<EffectLine> lines;
};

/// What calls for each effect. @param profile  of `ticks` ticks; null: nothing was measured
EffectReport reportEffects(const World& world, const Effects& effects, const Profile* profile, int ticks);

/// Plays some ticks, and the same ones without each effect that runs, to see what that saves. The game is
/// afterwards as it was.
/// @param profile  a service of the game's world from now on, so it has to outlive its last tick
EffectReport measureEffects(Game& game, Profile& profile, int ticks);

/// The report as a table.
std::string effectText(const EffectReport& report);

}  // namespace plumb
