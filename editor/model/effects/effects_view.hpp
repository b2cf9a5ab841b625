#pragma once

#include <string>
#include <vector>

#include "app/effect_list.hpp"
#include "app/effect_rows.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Data of the panel "Effects": all effects (optional features of the engine) of the open scene or running
/// game, the components that require them, and their costs.
class EffectsView {
public:
    static constexpr std::size_t kTicks = 60;  ///< ticks over which costs are averaged (1 s)

    struct Line {
        std::size_t row = 0;      ///< index in the effect table
        bool runs = false;        ///< the effect is active
        bool isRequired = false;  ///< a component requires the effect
        bool inPhysics = false;   ///< an effect of the physics
        Pin pin = Pin::Auto;      ///< setting in the open scene's file: on, off, or auto (only if required)
        std::string pinnedBy{};   ///< in the running game: path of another scene that sets it to on or off
        std::vector<EffectCount> requesters{};  ///< components that require the effect, with their numbers
        EffectZones zones{};                    ///< measured parts of a tick that belong to the effect
        bool measured = false;                  ///< a game runs, and the effect has measured parts of its own
        float milliseconds = 0.0f;              ///< mean time per tick
        float share = 0.0f;                     ///< ratio to the time of the tick
    };

    /// Updates the data if the scene changed or the game advanced.
    void refresh(const Workspace& workspace);
    [[nodiscard]] const EffectTable& table() const { return *table_; }
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
    [[nodiscard]] float tickMilliseconds() const { return tick_; }  ///< mean of a tick; 0: not measured
    [[nodiscard]] std::size_t running() const;

private:
    void lookAtScene(const Workspace& workspace, bool recount);
    void lookAtGame(const Workspace& workspace, bool recount);
    void readCosts(const Profiler& profiler);

    const EffectTable* table_ = &engineEffects();
    std::vector<Line> lines_;
    float tick_ = 0.0f;
    float overhead_ = -1.0f;  // time of measuring a zone, ms; below 0: unknown
    std::uint64_t revision_ = ~std::uint64_t{0};
    std::int64_t ticks_ = -1;
};

/// Returns the settings on, off or auto of all effects in the open scene, indexed by row of the table.
std::vector<Pin> pinsOf(const Document& document, const EffectTable& table);

/// Selects the entities of the shown world whose component of this type requires the effect.
void selectRequesters(Workspace& workspace, const EffectRow& row, const TypeInfo& type);

/// Sets an effect of the open scene to on, off or auto, as one undo step. No effect while the game runs.
void pinEffect(Workspace& workspace, std::string_view effect, Pin pin);

}  // namespace plumb::editor
