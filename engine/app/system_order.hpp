#pragma once

#include <span>
#include <string_view>

#include "ecs/world.hpp"

namespace plumb {

/// One row of the table of all systems.
struct SystemRow {
    std::string_view name;    ///< S::kName
    std::string_view effect;  ///< for which it runs, of effect_rows.cpp; empty: always
    TypeKey (*key)();
    void (*add)(World& world);
};

/// Every system of the engine in the order in which a tick runs them.
std::span<const SystemRow> systemTable();

/// Makes the world run its systems in the table's order, those a game adds itself after them.
void useSystemOrder(World& world);

/// Adds every system of the table, for worlds that are made of scenes.
void addAllSystems(World& world);

}  // namespace plumb
