#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "physics/contacts/detection_counts.hpp"

namespace plumb {

class World;

/// What the last tick's search for contacts cost. A resource, only to be shown: no hash includes it.
struct PhysicsCounts {
    physics::DetectionCounts detection;
};

/// What a Label says of the physics of the last tick: {bodies}, {contacts}, {joints}, and the phases of
/// detection: of {pairs} whose grown bounds overlap, {circles}, {boxes} and {axes} are how many were found
/// apart by their bounding circles, then by their boxes, then by separating axes; {kept} needed no new look,
/// {touching} touch. Nothing for other words.
std::optional<std::int64_t> physicsCount(const World& world, std::string_view word);

}  // namespace plumb
