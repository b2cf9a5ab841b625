#include "ecs/system_gates.hpp"

#include <algorithm>

namespace plumb {

std::size_t SystemGates::add(TypeKey system, bool (*isRequired)(const World& world)) {
    gates_.push_back({system, isRequired});
    places_.clear();
    return gates_.size() - 1;
}

/// Called rarely: after a system was added or the order was changed.
void SystemGates::findGate(std::size_t place, TypeKey system) {
    if (place >= places_.size()) places_.resize(place + 1);
    const auto found =
        std::find_if(gates_.begin(), gates_.end(), [=](const Gate& gate) { return gate.system == system; });
    places_[place] = {system,
                      found == gates_.end() ? kNone : static_cast<std::size_t>(found - gates_.begin())};
}

bool SystemGates::shouldRun(const World& world, std::size_t place, TypeKey system) {
    if (place >= places_.size() || places_[place].system != system) findGate(place, system);
    const std::size_t number = places_[place].gate;
    if (number == kNone) return true;
    Gate& gate = gates_[number];
    const bool called = gate.isRequired(world);
    const bool runs = gate.pin == Pin::Auto ? called : gate.pin == Pin::On;
    gate.runs += runs ? 1 : 0;
    // A system pinned off must not run, not even the first time, if there are components for it to process.
    if (!runs && (gate.begun || called)) return false;
    gate.begun = true;
    return true;
}

}  // namespace plumb
