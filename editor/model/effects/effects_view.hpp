#pragma once

#include <string>
#include <vector>

#include "app/effect_list.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// What the panel "Effects" shows: every effect of the open scene or of the game that plays, what calls for
/// it, and what it costs.
class EffectsView {
public:
    static constexpr std::size_t kTicks = 60;  ///< that costs are the mean of: a second

    struct Line {
        std::size_t row = 0;
        bool runs = false;
        bool calledFor = false;
        bool inPhysics = false;
        Pin pin = Pin::Auto;     ///< in the file of the open scene
        std::string pinnedBy{};  ///< in the game that plays: the path of another scene that pins it
        std::vector<EffectCount> callers{};
        EffectZones zones{};
        bool measured = false;  ///< while the game plays, and for what runs alone
        float milliseconds = 0.0f;
        float share = 0.0f;  ///< ratio of the tick
    };

    /// Looks again, when the scene changed or the game went on.
    void refresh(const Workspace& workspace);
    [[nodiscard]] const EffectTable& table() const;
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
    [[nodiscard]] float tickMilliseconds() const { return tick_; }  ///< the mean; 0: nothing was measured
    [[nodiscard]] std::size_t running() const;

private:
    void lookAtScene(const Workspace& workspace, bool recount);
    void lookAtGame(const Workspace& workspace, bool recount);
    void readCosts(const Profiler& profiler);

    std::vector<Line> lines_;
    float tick_ = 0.0f;
    float overhead_ = -1.0f;  // ms that measuring a zone takes; below 0: not known yet
    std::uint64_t revision_ = ~std::uint64_t{0};
    std::int64_t ticks_ = -1;
};

/// The effects that the open scene pins, by row of the table.
std::vector<Pin> pinsOf(const Document& document, const EffectTable& table);

/// Selects the entities of the shown world whose component of this kind calls for an effect.
void selectCallers(Workspace& workspace, const EffectRow& row, const TypeInfo& type);

/// Pins an effect in the open scene: one step of undo. Nothing while the game plays.
void pinEffect(Workspace& workspace, std::string_view effect, Pin pin);

}  // namespace plumb::editor
