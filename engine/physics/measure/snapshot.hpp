#pragma once

#include "physics/simulation.hpp"

namespace plumb::physics {

/// Serializes a world, for a file or a network; in memory, copy the World instead. A restored world continues
/// with the same bits as the original. Events of the last step are not included.
[[nodiscard]] std::vector<std::uint8_t> toBytes(const World& world);
/// @error bytes of another version or byte order, or corrupted bytes. Maliciously crafted bytes are not
///         detected: use trusted sources only.
Result<World> worldFrom(std::span<const std::uint8_t> bytes);

/// Records a world: the initial state, all changes between steps, and the hash after each step. Each step
/// costs two additional passes over the state.
class WorldRecording {
public:
    WorldRecording() = default;
    explicit WorldRecording(const World& world);

    /// Performs a step, and records it and the changes since the last step.
    void step(World& world, float dt, const StepOptions& options = {});
    [[nodiscard]] std::size_t steps() const { return steps_.size(); }
    /// Replays `count` steps and returns the world after them. Pass the hooks that were used to record.
    /// @error the state after a step differs from the recorded one, or fewer than `count` steps were recorded
    [[nodiscard]] Result<World> replay(std::size_t count, const StepOptions& options = {}) const;

    [[nodiscard]] std::vector<std::uint8_t> toBytes() const;
    /// @error the same errors as worldFrom()
    static Result<WorldRecording> from(std::span<const std::uint8_t> bytes);

    using Bytes = std::vector<std::uint8_t>;

private:
    struct Step {
        std::uint64_t hash;                                    ///< hash of the world after the step
        float dt;                                              ///< s
        std::vector<std::pair<std::uint64_t, Bytes>> changes;  ///< new content of parts of the state
    };

    std::vector<Bytes> start_;
    std::vector<Bytes> last_;  ///< the state after the last step; empty for a loaded recording
    std::vector<Step> steps_;
};

}  // namespace plumb::physics
