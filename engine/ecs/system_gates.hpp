#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reflect/type_key.hpp"

namespace plumb {

class World;

/// Whether something runs because somebody calls for it, always, or never.
enum class Pin : std::uint8_t { Auto, On, Off };

/// Which systems of a world run: those that somebody calls for. A service of the world, so it has to outlive
/// the last tick. A system without a gate always runs, and so do all of a world without this.
///
/// Who calls is asked right before a system's turn, so that what an earlier system made is heard in the same
/// tick. The answer is a look at the sizes of a few pools, however many entities there are.
class SystemGates {
public:
    struct Gate {
        TypeKey system = 0;
        bool (*calledFor)(const World& world) = nullptr;
        Pin pin = Pin::Auto;
        std::uint64_t runs = 0;  ///< how often the system ran
    };

    /// @return the number of the gate
    std::size_t add(TypeKey system, bool (*calledFor)(const World& world));
    void setPin(std::size_t gate, Pin pin) { gates_[gate].pin = pin; }
    [[nodiscard]] const Gate& gate(std::size_t number) const { return gates_[number]; }

    /// Whether the system at this place of the schedule runs now. Counts it.
    [[nodiscard]] bool admits(const World& world, std::size_t place, TypeKey system) {
        if (place >= places_.size() || places_[place].system != system) [[unlikely]]
            findGate(place, system);
        const std::size_t number = places_[place].gate;
        if (number == kNone) return true;
        Gate& gate = gates_[number];
        const bool runs = gate.pin == Pin::Auto ? gate.calledFor(world) : gate.pin == Pin::On;
        gate.runs += runs ? 1 : 0;
        return runs;
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// A place of the schedule.
    struct Place {
        TypeKey system = 0;
        std::size_t gate = kNone;
    };

    void findGate(std::size_t place, TypeKey system);

    std::vector<Gate> gates_;
    std::vector<Place> places_;
};

}  // namespace plumb
