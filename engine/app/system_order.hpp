#pragma once

#include <span>
#include <string_view>

#include "ecs/world.hpp"

namespace plumb {

/// An entry of the table of all systems.
struct SystemRow {
    std::string_view name;      ///< name of the system, e.g. its kName
    std::string_view effect;    ///< name of the effect (effect_rows.cpp) for which it runs; empty: always
    TypeKey (*key)();           ///< returns the key of the system's type
    void (*add)(World& world);  ///< adds the system to a world
};

/// Returns all systems of the engine in their order of execution.
std::span<const SystemRow> systemTable();

}  // namespace plumb
