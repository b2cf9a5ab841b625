#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/effects.hpp"

namespace plumb {

class Game;
class Profile;

/// Profiler zones of a tick that belong to an effect (an optional feature of the engine).
struct EffectZones {
    std::vector<std::string_view> own;  ///< systems and stages of the physics that run only for this effect
    std::vector<std::string_view> shared;  ///< stages of the physics that other effects need too
};
EffectZones zonesOf(const EffectTable& table, std::size_t row);

/// Number of components of a type that request an effect.
struct EffectCount {
    const TypeInfo* type = nullptr;
    std::size_t count = 0;
};
/// Returns the components that currently request an effect, without types that no entity has.
std::vector<EffectCount> requestersOf(const World& world, const EffectRow& row);

/// Returns the first component types that can request an effect as text, e.g. "Door, Button".
std::string missingRequesters(const EffectRow& row);

/// Measures the overhead of a profiler zone, s per call, to subtract it from measured times.
double zoneOverhead();

/// State and cost of one effect in a world, for display.
struct EffectLine {
    std::size_t row = 0;      ///< index of the effect in the table
    bool isRequired = false;  ///< a component requests it
    bool runs = false;        ///< it runs: because of a request or its pin
    Pin pin = Pin::Auto;      ///< On or Off: runs or does not, whatever components request
    std::string pinnedBy;     ///< path of the scene that pins it; empty: not pinned, or pinned by the program
    std::vector<EffectCount> requesters;
    EffectZones zones;
    double microseconds = 0.0;  ///< µs per tick in its own zones
    double saves = 0.0;         ///< µs per tick that turning it off saves; measured, so it may be negative
};

/// State and cost of all effects of a game.
struct EffectReport {
    const EffectTable* table = nullptr;
    int ticks = 0;              ///< number of measured ticks; 0: not measured
    double microseconds = 0.0;  ///< µs of a whole tick
    std::vector<EffectLine> lines;
};

/// Returns which components request each effect. @param profile  profile of `ticks` ticks; null: not measured
EffectReport reportEffects(const World& world, const Effects& effects, const Profile* profile, int ticks);

/// Measures what each running effect costs: plays some ticks, and the same ticks without the effect. The
/// game's state is restored afterwards.
/// @param profile  becomes a service of the game's world, so it must outlive the world's last tick
EffectReport measureEffects(Game& game, Profile& profile, int ticks);

/// Returns the report as a text table.
std::string effectText(const EffectReport& report);

}  // namespace plumb
