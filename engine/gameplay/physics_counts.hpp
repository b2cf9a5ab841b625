#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "physics/contacts/detection_counts.hpp"

namespace plumb {

class World;

/// Counters of collision detection in the last tick. A world
/// resource for display only, not included in the hash.
struct PhysicsCounts {
    static constexpr bool kNotSaved = true;

    physics::DetectionCounts detection;
};

/// Returns the value of a physics placeholder in a Label, for the last tick: "bodies",
/// "contacts", "joints", "pairs" (with overlapping enlarged bounds), "circles", "boxes",
/// "axes" (pairs rejected by bounding circles, bounds, separating axes), "kept"
/// (touching pairs whose points were reused), "touching". nullopt for other words.
std::optional<std::int64_t> physicsCount(const World& world, std::string_view word);

}  // namespace plumb
