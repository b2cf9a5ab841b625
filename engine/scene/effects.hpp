#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/effect_table.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb {

/// Which effects of a world run: those that components call for, and what is pinned. A service of the
/// world, so it has to outlive the last tick.
///
/// All scenes of a stack share it. What pins an effect, from the strongest on: a measurement (`setMeasured`),
/// the topmost scene that names the effect, the program (`setProgram`).
class Effects {
public:
    /// Gates the systems of the world, and is its service from now on.
    Effects(const EffectTable& table, World& world);
    Effects(const Effects&) = delete;
    Effects& operator=(const Effects&) = delete;

    [[nodiscard]] const EffectTable& table() const { return table_; }

    /// Takes over what the scenes of the world say, when they are others than before. Once a tick.
    void followScenes(World& world);

    [[nodiscard]] Pin pinOf(std::size_t row) const { return pins_[row]; }
    /// The path of the scene that pins it; empty for none.
    [[nodiscard]] const std::string& pinnedBy(std::size_t row) const { return pinnedBy_[row]; }
    /// Whether something calls for it, in O(1).
    [[nodiscard]] bool calledFor(const World& world, std::size_t row) const;
    [[nodiscard]] bool runs(const World& world, std::size_t row) const {
        return pins_[row] == Pin::Auto ? calledFor(world, row) : pins_[row] == Pin::On;
    }
    [[nodiscard]] bool runs(const World& world, std::string_view name) const {
        return runs(world, table_.find(name));
    }
    /// How often it was at work: in how many ticks its systems or its part of the physics ran; how often its
    /// device was opened; how many layers of animated tiles were drawn.
    [[nodiscard]] std::uint64_t runsOf(World& world, std::size_t row) const;
    [[nodiscard]] std::uint64_t runsOf(World& world, std::string_view name) const {
        return runsOf(world, table_.find(name));
    }

    /// Bits of physics::Manifest.
    [[nodiscard]] std::uint32_t physicsOn() const { return physicsOn_; }
    [[nodiscard]] std::uint32_t physicsOff() const { return physicsOff_; }

    /// What a program wants where no scene says anything: a game in code may need what no component calls
    /// for.
    void setProgram(std::string_view name, Pin pin);
    /// To see what an effect costs: goes before all that scenes say.
    void setMeasured(std::size_t row, Pin pin);
    /// It was at work where no system is: a device was opened for it, or something drawn.
    void count(std::string_view name) { ++counted_[table_.find(name)]; }

private:
    void readScenes(const LoadedScenes& loaded);
    void mix();

    const EffectTable& table_;
    SystemGates gates_;
    std::vector<std::size_t> gateOf_;  // by system of the table; kNone for one that always runs
    std::vector<Pin> program_, scenes_, measured_, pins_;
    std::vector<std::string> pinnedBy_;
    std::vector<std::uint64_t> counted_;                   // by row
    std::vector<std::shared_ptr<const SceneRest>> known_;  // of the scenes that were read
    std::uint32_t physicsOn_ = 0;
    std::uint32_t physicsOff_ = 0;
};

}  // namespace plumb
