#include "ecs/system_gates.hpp"

#include <algorithm>

namespace plumb {

std::size_t SystemGates::add(TypeKey system, bool (*calledFor)(const World& world)) {
    gates_.push_back({system, calledFor});
    places_.clear();
    return gates_.size() - 1;
}

/// Rare: after a system was added or the order was changed.
void SystemGates::findGate(std::size_t place, TypeKey system) {
    if (place >= places_.size()) places_.resize(place + 1);
    const auto found =
        std::find_if(gates_.begin(), gates_.end(), [=](const Gate& gate) { return gate.system == system; });
    places_[place] = {system,
                      found == gates_.end() ? kNone : static_cast<std::size_t>(found - gates_.begin())};
}

bool SystemGates::admits(const World& world, std::size_t place, TypeKey system) {
    if (place >= places_.size() || places_[place].system != system) findGate(place, system);
    const std::size_t number = places_[place].gate;
    if (number == kNone) return true;
    Gate& gate = gates_[number];
    const bool called = gate.calledFor(world);
    const bool runs = gate.pin == Pin::Auto ? called : gate.pin == Pin::On;
    gate.runs += runs ? 1 : 0;
    // A system pinned off must not run, not even its first time, if there is something that it would process.
    if (!runs && (gate.begun || called)) return false;
    gate.begun = true;
    return true;
}

}  // namespace plumb
