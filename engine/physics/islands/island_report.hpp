#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Statistics of an awake island (bodies connected by contacts or joints) after a step.
struct IslandReport {
    BodyId first;                ///< its body with the lowest index
    std::uint32_t bodies = 0;    ///< number of dynamic bodies
    std::uint32_t contacts = 0;  ///< number of contacts that exert forces, including those with static bodies
    std::uint32_t joints = 0;
    Quality quality = 0;      ///< 2^quality substeps in the last step
    float overlap = 0.0f;     ///< m: maximum over its contacts
    float jointError = 0.0f;  ///< m: maximum error of its joints
    float speed = 0.0f;       ///< m/s: maximum over its bodies
};

/// Returns all awake islands, sorted by their first body. For tools: slow, recomputes islands and allocates.
[[nodiscard]] std::vector<IslandReport> reportIslands(const World& world);

/// Returns, by BodyId::index, the body's index in reportIslands(world); kNone if asleep or not dynamic.
[[nodiscard]] std::vector<std::uint32_t> islandIndices(const World& world);

}  // namespace plumb::physics
