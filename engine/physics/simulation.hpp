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
    TaskPool* pool = nullptr;    ///< threads; their number does not affect the result
    Profile* profile = nullptr;  ///< receives the time of each stage, by name
    ContactHooks hooks{};
    /// Minimum number of awake bodies, contacts and joints for more than one thread. 4,000 take about 0.3 ms,
    /// longer than synchronizing a hundred parallel loops (0.4 us per cache line from core to core).
    std::size_t minimumWork = 4000;
};

/// True if a step of this world has enough work for several threads: StepOptions::minimumWork.
[[nodiscard]] inline bool isWorthThreads(const World& world, const StepOptions& options = {}) {
    return world.awake.size() + world.contacts.size() + world.joints.awake.size() >= options.minimumWork;
}

/// Advances the world by dt (s). The result has the same bits on every machine, for any number of threads and
/// any instruction set. If dt is not finite or not above 0, only the events are cleared; else it is limited to
/// the range from kShortestStep to kLongestStep (1 us to 1 s). Games use 1/60 s.
void step(World& world, float dt, const StepOptions& options = {});

/// A stage of the step. It runs if one of its effects runs or `also` returns true; without both, always.
struct StageInfo {
    std::string_view name;  ///< name, also in the profiler
    std::uint32_t effects;  ///< bits: see Manifest::bit()
    void (*run)(StepContext& step);
    bool (*also)(const StepContext& step) = nullptr;
};
/// Returns the stages in the order of execution.
std::span<const StageInfo> stages();

/// Returns how often the stage with this name has run in this world; 0 if there is no such stage.
[[nodiscard]] std::uint64_t runsOf(World& world, std::string_view stage);
/// Returns in how many steps of this world the code of an effect has run: its stage, or its part of a stage.
[[nodiscard]] std::uint64_t runsOf(World& world, Effect effect);

/// Returns counts of the last step's collision detection; all 0 if the world is at rest or was copied since.
[[nodiscard]] DetectionCounts detectionOf(World& world);

/// Hashes the whole state; equal states give equal hashes on every machine.
[[nodiscard]] std::uint64_t hashOf(const World& world);
void addTo(Hasher& hasher, const World& world);
/// Returns the size of the state of a world, in bytes.
[[nodiscard]] std::size_t stateBytes(const World& world);

}  // namespace plumb::physics
