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
///
/// At its first turn a system runs once for nobody, so that its queries are made. Past 63 kinds of components
/// the order of iteration depends on which were used first: it must not depend on who calls for what.
class SystemGates {
public:
    struct Gate {
        TypeKey system = 0;
        bool (*calledFor)(const World& world) = nullptr;
        Pin pin = Pin::Auto;
        std::uint64_t runs = 0;  ///< how often the system ran for somebody, or because it is pinned on
        bool begun = false;      ///< its queries are made
    };

    /// @return the number of the gate
    std::size_t add(TypeKey system, bool (*calledFor)(const World& world));
    void setPin(std::size_t gate, Pin pin) { gates_[gate].pin = pin; }
    [[nodiscard]] const Gate& gate(std::size_t number) const { return gates_[number]; }

    /// Whether the system at this place of the schedule runs now. Counts it.
    [[nodiscard]] bool admits(const World& world, std::size_t place, TypeKey system);

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
