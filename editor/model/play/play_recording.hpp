#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "ecs/snapshot.hpp"
#include "input/input_frame.hpp"

namespace plumb::editor {

/// The last 30 s of a game: its world as it was now and then, and what the player's hands did in every tick.
/// The simulation repeats itself to the last bit, so any tick between comes back by playing on from the world
/// before it.
class PlayRecording {
public:
    static constexpr std::int64_t kTicks = 30 * 60;                ///< ticks that can be gone back
    static constexpr std::size_t kBytes = std::size_t{192} << 20;  ///< of all kept worlds

    struct Keyframe {
        std::int64_t tick = 0;
        std::size_t bytes = 0;  ///< about what it takes
        std::unique_ptr<Snapshot> world;
    };

    /// Forgets all and keeps the world as that of a tick.
    void begin(std::int64_t tick, const World& world);
    void clear();
    /// The input of the next tick, which is about to run.
    void record(const InputFrame& input) { inputs_.push_back(input); }
    /// After that tick: keeps the world when it is time for it, forgets what is too old.
    void tickDone(const World& world);
    /// What came after this tick did not happen.
    void cut(std::int64_t tick);

    [[nodiscard]] std::int64_t oldest() const;  ///< first tick that can be gone back to
    [[nodiscard]] std::int64_t newest() const { return first_ + static_cast<std::int64_t>(inputs_.size()); }
    /// What the hands did in the tick that follows on `tick`. @pre oldest() <= tick < newest()
    [[nodiscard]] const InputFrame& inputAfter(std::int64_t tick) const {
        return inputs_[static_cast<std::size_t>(tick - first_)];
    }
    /// The last kept world that is not later than `tick`. @pre oldest() <= tick
    [[nodiscard]] const Keyframe& before(std::int64_t tick) const;
    [[nodiscard]] const std::deque<Keyframe>& keyframes() const { return keyframes_; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    [[nodiscard]] std::int64_t spacing() const { return spacing_; }  ///< ticks between two kept worlds

private:
    void keep(std::int64_t tick, const World& world);
    void drop(Keyframe& keyframe);
    void thin();

    std::deque<Keyframe> keyframes_;  // by tick
    std::deque<InputFrame> inputs_;   // of the ticks after `first_`
    std::int64_t first_ = 0;
    std::int64_t spacing_ = 0;
    std::size_t bytes_ = 0;
    std::vector<std::unique_ptr<Snapshot>> spare_;  // their memory is used again
};

}  // namespace plumb::editor
