#pragma once

#include "physics/simulation.hpp"

namespace plumb::physics {

/// The state of a world as bytes, for a file or a network; in memory, a copy of the World is simpler. A world
/// from bytes goes on with the bits of the original. Events of the last step are not part of it.
[[nodiscard]] std::vector<std::uint8_t> toBytes(const World& world);
/// @error bytes of another version or kind of machine, or bytes that were changed by accident. Bytes that
///        were forged are not recognized: take them from sources that you trust.
Result<World> worldFrom(std::span<const std::uint8_t> bytes);

/// Records a world with all that is done to it: its state at the start, what changed between steps, and the
/// hash after each step. A step costs two passes over the state more.
class WorldRecording {
public:
    WorldRecording() = default;
    explicit WorldRecording(const World& world);

    /// Does a step, and records it with what was changed since the last one.
    void step(World& world, float dt, const StepOptions& options = {});
    [[nodiscard]] std::size_t steps() const { return steps_.size(); }
    /// The world after so many steps, done again. Pass the hooks with which they were recorded.
    /// @error a step gave another state than in the recording, or there are fewer
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
