#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "ecs/snapshot.hpp"
#include "input/input_frame.hpp"

namespace plumb::editor {

/// Recording of the last 30 s of a game: snapshots of its world at some ticks (keyframes), and the input of
/// every tick. The simulation is deterministic, so the state after any tick is restored exactly by simulating
/// from the keyframe before it.
class PlayRecording {
public:
    static constexpr std::int64_t kTicks = 30 * 60;                ///< maximum ticks to rewind
    static constexpr std::size_t kBytes = std::size_t{192} << 20;  ///< memory limit of all keyframes together

    struct Keyframe {
        std::int64_t tick = 0;
        std::size_t bytes = 0;  ///< estimated size
        std::unique_ptr<Snapshot> world;
    };

    /// Clears the recording and saves the world as the keyframe of `tick`.
    void begin(std::int64_t tick, const World& world);
    void clear();
    /// Records the input of the next tick; to be called before the tick.
    void record(const InputFrame& input) { inputs_.push_back(input); }
    /// Saves a keyframe if one is due, and removes data older than 30 s; to be called after the newest
    /// recorded tick has run, at least once.
    void tickDone(const World& world);
    /// Removes everything recorded after `tick`.
    void cut(std::int64_t tick);

    [[nodiscard]] std::int64_t oldest() const;  ///< the first tick that can be restored
    [[nodiscard]] std::int64_t newest() const { return first_ + static_cast<std::int64_t>(inputs_.size()); }
    /// The input of the tick after `tick`. @pre oldest() <= tick < newest()
    [[nodiscard]] const InputFrame& inputAfter(std::int64_t tick) const {
        return inputs_[static_cast<std::size_t>(tick - first_)];
    }
    /// The last keyframe at or before `tick`. @pre oldest() <= tick
    [[nodiscard]] const Keyframe& before(std::int64_t tick) const;
    [[nodiscard]] const std::deque<Keyframe>& keyframes() const { return keyframes_; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    [[nodiscard]] std::int64_t spacing() const { return spacing_; }  ///< ticks between two keyframes

private:
    void keep(std::int64_t tick, const World& world);
    void drop(Keyframe& keyframe);
    void thin();  ///< removes about half of the keyframes, to free memory

    std::deque<Keyframe> keyframes_;                // sorted by tick
    std::deque<InputFrame> inputs_;                 // one per tick after `first_`
    std::int64_t first_ = 0;                        // tick before the first of `inputs_`
    std::int64_t spacing_ = 0;                      // ticks between two keyframes
    std::size_t bytes_ = 0;                         // estimated size of all keyframes
    std::vector<std::unique_ptr<Snapshot>> spare_;  // removed snapshots, whose memory is reused
};

}  // namespace plumb::editor
