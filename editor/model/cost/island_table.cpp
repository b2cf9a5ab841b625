#include "editor/model/cost/island_table.hpp"

#include <algorithm>
#include <cmath>

#include "physics/model/bodies.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb::editor {
namespace {

/// Estimates the work of an island in a step, in arbitrary units. A contact or joint takes about twice as
/// long per substep as a body.
double workOf(const physics::IslandReport& island) {
    constexpr double kOnce = 6.0;  // collision detection and final updates, in units of a substep
    return (kOnce + std::exp2(island.quality)) *
           (static_cast<double>(island.bodies) + 2.0 * (island.contacts + island.joints));
}

double keyOf(const IslandRow& row, IslandColumn by) {
    const physics::IslandReport& island = row.report;
    switch (by) {
        case IslandColumn::Bodies: return island.bodies;
        case IslandColumn::Contacts: return island.contacts;
        case IslandColumn::Joints: return island.joints;
        case IslandColumn::Quality: return island.quality;
        case IslandColumn::Speed: return static_cast<double>(island.speed);
        case IslandColumn::Overlap: return static_cast<double>(island.overlap);
        case IslandColumn::JointError: return static_cast<double>(island.jointError);
        case IslandColumn::Cost: break;
    }
    return static_cast<double>(row.microseconds);
}

}  // namespace

std::vector<IslandRow> islandRows(const World& world, float stepMicroseconds) {
    const auto* state = world.findResource<PhysicsState>();
    if (state == nullptr) return {};
    std::vector<IslandRow> rows;
    double all = 0.0;
    for (const physics::IslandReport& island : physics::reportIslands(state->world)) {
        rows.push_back({island, 0.0f});
        all += workOf(island);
    }
    for (IslandRow& row : rows)
        row.microseconds =
            static_cast<float>(static_cast<double>(stepMicroseconds) * workOf(row.report) / all);
    return rows;
}

void sortIslands(std::vector<IslandRow>& rows, IslandColumn by, bool descending) {
    std::stable_sort(rows.begin(), rows.end(), [=](const IslandRow& a, const IslandRow& b) {
        return descending ? keyOf(a, by) > keyOf(b, by) : keyOf(a, by) < keyOf(b, by);
    });
}

std::vector<EntityId> entitiesOfIsland(const World& world, physics::BodyId body) {
    const auto* state = world.findResource<PhysicsState>();
    if (state == nullptr || !alive(state->world, body)) return {};
    const std::vector<std::uint32_t> indices = physics::islandIndices(state->world);
    std::vector<EntityId> entities;
    if (indices[body.index] == physics::kNone) return entities;
    for (std::uint32_t other = 0; other < indices.size(); ++other) {
        if (indices[other] != indices[body.index]) continue;
        const physics::BodyId id{other, state->world.bodies.info[other].generation};
        entities.push_back(ownerOf(*state, id));
    }
    return entities;
}

}  // namespace plumb::editor
