#pragma once

#include <cstdint>
#include <vector>

#include "ecs/world.hpp"
#include "physics/islands/island_report.hpp"

namespace plumb::editor {

/// One awake island, as a row of the table in the panel.
struct IslandRow {
    physics::IslandReport report;
    float microseconds = 0.0f;  ///< estimated share of the step's time
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

/// Returns the awake islands of a world's physics.
/// @param stepMicroseconds  time of the last step, which is divided among the islands
std::vector<IslandRow> islandRows(const World& world, float stepMicroseconds);

void sortIslands(std::vector<IslandRow>& rows, IslandColumn by, bool descending);

/// Returns the entities in the present island of this body; none if it sleeps or was destroyed.
std::vector<EntityId> entitiesOfIsland(const World& world, physics::BodyId body);

}  // namespace plumb::editor
