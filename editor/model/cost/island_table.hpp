#pragma once

#include <cstdint>
#include <vector>

#include "ecs/world.hpp"
#include "physics/islands/island_report.hpp"

namespace plumb::editor {

/// One island that is awake, as the table of the panel shows it.
struct IslandRow {
    physics::IslandReport report;
    float microseconds = 0.0f;  ///< about: its share of the step, by what it has to solve
};

enum class IslandColumn : std::uint8_t {
    Bodies,
    Contacts,
    Joints,
    Quality,
    Speed,
    Overlap,
    JointError,
    Cost
};

/// The islands of the physics of a world.
/// @param stepMicroseconds  of the last step, to be shared among them
std::vector<IslandRow> islandRows(const World& world, float stepMicroseconds);

void sortIslands(std::vector<IslandRow>& rows, IslandColumn by, bool descending);

/// The entities that have bodies in the island of this body, as it is now; none when it sleeps or is gone.
std::vector<EntityId> entitiesOfIsland(const World& world, physics::BodyId body);

}  // namespace plumb::editor
