#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// An awake island after a step: bodies connected by contacts or joints.
struct IslandReport {
    BodyId first;                ///< the body with the lowest index
    std::uint32_t bodies = 0;    ///< dynamic ones
    std::uint32_t contacts = 0;  ///< that push, those with the ground included
    std::uint32_t joints = 0;
    Quality quality = 0;      ///< 2^quality substeps in the last step
    float overlap = 0.0f;     ///< m: maximum over its contacts
    float jointError = 0.0f;  ///< m: maximum error of its joints
    float speed = 0.0f;       ///< m/s: maximum over its bodies
};

/// All awake islands, sorted by their first body. For tools, not each step: it recomputes them and allocates.
[[nodiscard]] std::vector<IslandReport> reportIslands(const World& world);

/// Index in `reportIslands(world)` of each body's island, by BodyId::index; kNone if it sleeps or is not
/// dynamic.
[[nodiscard]] std::vector<std::uint32_t> islandIndices(const World& world);

}  // namespace plumb::physics
