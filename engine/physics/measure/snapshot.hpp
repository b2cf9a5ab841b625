#pragma once

#include "physics/simulation.hpp"

namespace plumb::physics {

/// The state of a world as bytes, for a file or a network; in memory, copy the World instead. A world that
/// is restored continues with the same bits as the original. Events of the last step are not included.
[[nodiscard]] std::vector<std::uint8_t> toBytes(const World& world);
/// @error bytes of another version or kind of machine, or bytes that were corrupted. Deliberately forged
/// bytes are not detected: use trusted sources only.
Result<World> worldFrom(std::span<const std::uint8_t> bytes);

/// Records a world and all changes to it: the initial state, what changed between steps,
/// and the hash after each step. Each step costs two additional passes over the state.
class WorldRecording {
public:
    WorldRecording() = default;
    explicit WorldRecording(const World& world);

    /// Performs a step, and records it and the changes since the last one.
    void step(World& world, float dt, const StepOptions& options = {});
    [[nodiscard]] std::size_t steps() const { return steps_.size(); }
    /// Replays `count` steps and returns the world after them. Pass the hooks that were used to record.
    /// @error a step gave a different state than when it was recorded, or there are fewer steps
    [[nodiscard]] Result<World> replay(std::size_t count, const StepOptions& options = {}) const;

    [[nodiscard]] std::vector<std::uint8_t> toBytes() const;
    /// @error as worldFrom()
    static Result<WorldRecording> from(std::span<const std::uint8_t> bytes);

    using Bytes = std::vector<std::uint8_t>;

private:
    struct Step {
        std::uint64_t hash;                                    ///< of the world after it
        float dt;                                              ///< s
        std::vector<std::pair<std::uint64_t, Bytes>> changes;  ///< new content of parts of the state
    };

    std::vector<Bytes> start_;
    std::vector<Bytes> last_;  ///< the state after the last step; empty for one that was loaded
    std::vector<Step> steps_;
};

}  // namespace plumb::physics
