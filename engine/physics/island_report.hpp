#pragma once

#include <cstdint>
#include <vector>

#include "physics/world.hpp"

namespace plumb::physics {

/// An island that is awake: bodies that touch or are tied to each other, as they are after a step.
struct IslandReport {
    BodyId first;                ///< the one of its bodies with the lowest index
    std::uint32_t bodies = 0;    ///< that can be pushed
    std::uint32_t contacts = 0;  ///< that push, those with the ground included
    std::uint32_t joints = 0;
    Quality quality = 0;      ///< 2^quality substeps, in the last step
    float overlap = 0.0f;     ///< m: the largest of its contacts
    float jointError = 0.0f;  ///< m: how far the worst of its joints is open
    float speed = 0.0f;       ///< m/s: of its fastest body
};

/// All islands that are awake, by their first body. For those who look at a world, not for each step: it
/// makes the islands anew and allocates.
[[nodiscard]] std::vector<IslandReport> reportIslands(const World& world);

/// Which of `reportIslands(world)` each body is in, by BodyId::index; kNone for what is asleep or cannot be
/// pushed.
[[nodiscard]] std::vector<std::uint32_t> islandIndices(const World& world);

/// The same of one body.
[[nodiscard]] std::uint32_t islandIndexOf(const World& world, BodyId body);

}  // namespace plumb::physics
