#pragma once

#include "physics/contacts/detection_counts.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/joints.hpp"
#include "physics/model/shapes.hpp"

namespace plumb {
class Hasher;
class Profile;
class TaskPool;
}  // namespace plumb

namespace plumb::physics {

struct StepContext;

struct StepOptions {
    TaskPool* pool = nullptr;    ///< threads to share the work; the result has the same bits for any number
    Profile* profile = nullptr;  ///< receives the time of each stage, by name
    ContactHooks hooks{};
    /// Awake bodies, contacts and joints: a step with fewer is done by one thread. 4,000 cost about 0.3 ms,
    /// which pays for some hundred rounds of shared work even where a cache line takes 0.4 us between two
    /// cores.
    std::size_t minimumWork = 4000;
};

/// Whether a step of this world has enough work for several threads: StepOptions::minimumWork.
[[nodiscard]] bool isWorthThreads(const World& world, const StepOptions& options = {});

/// Advances the world by dt (s). The same world and dt give the same bits on every machine, for any number of
/// threads and any instruction set. If dt is not finite or not above 0, only the events are cleared.
void step(World& world, float dt, const StepOptions& options = {});

/// A stage runs when one of its effects does or `also` is true; without either, always.
struct StageInfo {
    std::string_view name;  ///< also in the profiler
    std::uint32_t effects;  ///< bits as in Manifest
    void (*run)(StepContext& step);
    bool (*also)(const StepContext& step) = nullptr;
};
/// The stages, in order.
std::span<const StageInfo> stages();

/// How often the stage of this name has run in this world; 0 if it never ran or does not exist.
[[nodiscard]] std::uint64_t runsOf(World& world, std::string_view stage);
/// In how many steps the code of an effect has run in this world: its own stage, or its part of one.
[[nodiscard]] std::uint64_t runsOf(World& world, Effect effect);

/// Counts of the collision detection of the last step; all 0 for a world at rest, copied or loaded since.
[[nodiscard]] DetectionCounts detectionOf(World& world);

/// Hashes the whole state; equal states give equal hashes on every machine.
[[nodiscard]] std::uint64_t hashOf(const World& world);
void addTo(Hasher& hasher, const World& world);
/// bytes: what a snapshot of the world copies.
[[nodiscard]] std::size_t stateBytes(const World& world);

}  // namespace plumb::physics
