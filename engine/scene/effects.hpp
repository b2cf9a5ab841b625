#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/effect_table.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb {

/// Decides which effects (optional features, see EffectRow) of a world run: those that components request,
/// unless they are pinned on or off. A service of the world, so it must outlive the last tick. A `row` is the
/// index of an effect in the table.
/// All scenes of a stack share it. Pins by decreasing priority: a measurement (setMeasuredPin()), the topmost
/// scene that names the effect, the program (setProgramPin()).
class Effects {
public:
    /// Registers itself and its system gates as services of the world.
    Effects(const EffectTable& table, World& world);
    Effects(const Effects&) = delete;
    Effects& operator=(const Effects&) = delete;

    /// Must be called after the table was changed. Resets the pins of setProgramPin() and setMeasuredPin().
    void tableChanged();
    [[nodiscard]] const EffectTable& table() const { return table_; }

    /// Updates the pins from the scenes of the world if these have changed. Call once per tick.
    void followScenes(World& world);

    [[nodiscard]] Pin pinOf(std::size_t row) const { return pins_[row]; }
    /// Returns the path of the scene that pins the effect; empty if no scene does.
    [[nodiscard]] const std::string& pinnedBy(std::size_t row) const { return pinnedBy_[row]; }
    /// True if the effect is requested; O(1).
    [[nodiscard]] bool isRequired(const World& world, std::size_t row) const;
    [[nodiscard]] bool runs(const World& world, std::size_t row) const {
        return pins_[row] == Pin::Auto ? isRequired(world, row) : pins_[row] == Pin::On;
    }
    [[nodiscard]] bool runs(const World& world, std::string_view name) const {
        return runs(world, table_.find(name));
    }
    /// Returns how often the effect ran: the number of ticks in which its systems or its part of the physics
    /// ran, plus the number of count() calls (opened devices, drawn layers of animated tiles).
    [[nodiscard]] std::uint64_t runsOf(World& world, std::size_t row) const;
    [[nodiscard]] std::uint64_t runsOf(World& world, std::string_view name) const {
        return runsOf(world, table_.find(name));
    }

    /// Bits of physics::Manifest: effects of the physics that are pinned on.
    [[nodiscard]] std::uint32_t physicsOn() const { return physicsOn_; }
    [[nodiscard]] std::uint32_t physicsOff() const { return physicsOff_; }

    /// Pins an effect unless a scene pins it, e.g. for game code that uses what no component requests.
    void setProgramPin(std::string_view name, Pin pin);
    /// Pins an effect with priority over scenes and program, to measure its cost.
    void setMeasuredPin(std::size_t row, Pin pin);
    /// Counts a use of an effect outside of systems: a device was opened or something was drawn.
    void count(std::string_view name) { ++counted_[table_.find(name)]; }

private:
    void makeGates();
    void readScenes(const LoadedScenes& loaded);
    void resolvePins();

    const EffectTable& table_;
    SystemGates gates_;
    std::vector<std::size_t> gateOf_;  // indexed by system: index of its gate; kNone if it always runs
    std::vector<Pin> program_, scenes_, measured_, pins_;
    std::vector<std::string> pinnedBy_;
    std::vector<std::uint64_t> counted_;  // indexed by effect: number of count() calls
    std::vector<std::shared_ptr<const SceneRest>>
        sceneContents_;  // content of the scenes whose pins were read
    std::uint32_t physicsOn_ = 0;
    std::uint32_t physicsOff_ = 0;
};

}  // namespace plumb
