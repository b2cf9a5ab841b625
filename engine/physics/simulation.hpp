#pragma once

#include <span>
#include <string_view>

#include "physics/bodies.hpp"
#include "physics/contact_hooks.hpp"
#include "physics/detection_counts.hpp"
#include "physics/joints.hpp"
#include "physics/shapes.hpp"
#include "physics/world.hpp"

namespace plumb {
class Profile;
class TaskPool;
}  // namespace plumb

namespace plumb::physics {

struct StepOptions {
    TaskPool* pool = nullptr;    ///< threads to share the work with; the bits do not depend on it
    Profile* profile = nullptr;  ///< where the time of each stage is added, by its name
    ContactHooks hooks{};
};

/// Moves the world on by dt (s). The same world and dt give the same bits on every machine, for any number of
/// threads and any instruction set. A dt that is no time (0, below it, not a number, infinite) does nothing
/// but clear the events.
void step(World& world, float dt, const StepOptions& options = {});

/// One chapter of the step.
struct StageInfo {
    std::string_view name;  ///< also the profiler's
    std::uint32_t effects;  ///< bits of Manifest: it runs when one of them does; 0 for always
};
/// The stages, in order.
std::span<const StageInfo> stages();

/// How often a stage of this name has run in this world; 0 for one that nothing called for.
[[nodiscard]] std::uint64_t runsOf(World& world, std::string_view stage);
/// In how many steps the code of an effect has run in this world: its stage, or its part of one.
[[nodiscard]] std::uint64_t runsOf(World& world, Effect effect);

/// What each phase of detection did in the last step; all 0 for a world at rest, and for one that was copied
/// or loaded since.
[[nodiscard]] DetectionCounts detectionOf(World& world);

/// Folds the whole state into a hash; equal states give equal numbers on every machine.
[[nodiscard]] std::uint64_t hashOf(const World& world);
void addTo(Hasher& hasher, const World& world);
/// What a snapshot of the world copies, in bytes.
[[nodiscard]] std::size_t stateBytes(const World& world);

}  // namespace plumb::physics
