#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reflect/type_key.hpp"

namespace plumb {

class World;

/// Override of a gate: its system runs only when required (Auto), always (On), or never (Off).
enum class Pin : std::uint8_t { Auto, On, Off };

/// Decides which systems of a world run: those that a component requires. A service of the world; it must
/// outlive the last tick. Systems without a gate always run, as do all in a world without this service.
///
/// Requirements are checked right before a system runs, so they include components that earlier systems
/// added in the same tick. The check only reads the sizes of a few pools, for any number of entities.
///
/// The first time that a system is due, it runs even if not required, so that its queries are created: with
/// more than 63 component types the order of iteration follows first use, which must not vary.
class SystemGates {
public:
    struct Gate {
        TypeKey system = 0;
        bool (*isRequired)(const World& world) = nullptr;  ///< true if a component requires the system
        Pin pin = Pin::Auto;
        std::uint64_t runs = 0;  ///< number of runs because it was required or pinned on
        bool begun = false;      ///< its queries have been created
    };

    /// @return the index of the gate
    std::size_t add(TypeKey system, bool (*isRequired)(const World& world));
    void setPin(std::size_t gate, Pin pin) { gates_[gate].pin = pin; }
    [[nodiscard]] const Gate& gate(std::size_t number) const { return gates_[number]; }

    /// True if the system at this position of the schedule runs now. Counts the run.
    [[nodiscard]] bool shouldRun(const World& world, std::size_t place, TypeKey system);

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// A position in the schedule.
    struct Place {
        TypeKey system = 0;
        std::size_t gate = kNone;  // index in gates_; kNone: the system has no gate
    };

    void findGate(std::size_t place, TypeKey system);

    std::vector<Gate> gates_;
    std::vector<Place> places_;
};

}  // namespace plumb
