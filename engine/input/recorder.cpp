#include "input/recorder.hpp"

#include <algorithm>
#include <array>

namespace plumb {

std::uint64_t Replay::ticks() const {
    std::uint64_t count = 0;
    for (const InputRun& run : runs) count += run.ticks;
    return count;
}

bool isPossible(const InputFrame& frame) {
    const auto isWithin = [](std::uint64_t bits, std::size_t count) { return bits >> count == 0; };
    const std::array<std::uint32_t, 4>& keys = frame.keys;
    return (keys[0] & 1) == 0 &&  // Key::None
           isWithin(keys[2] | std::uint64_t{keys[3]} << 32, kKeyCount - 64) &&
           isWithin(frame.mouseButtons, kMouseButtonCount) && isWithin(frame.connectedPads, kPadCount) &&
           std::all_of(frame.pads.begin(), frame.pads.end(),
                       [&](const PadFrame& pad) { return isWithin(pad.buttons, kPadButtonCount); });
}

void Recorder::record(const InputFrame& frame) {
    const bool same = !replay.runs.empty() && replay.runs.back().frame == frame;
    full_ = full_ || ticks_ == Replay::kMaxTicks || (!same && replay.runs.size() == Replay::kMaxRuns);
    if (full_) return;
    if (!same) replay.runs.push_back({frame, 0});
    ++replay.runs.back().ticks;
    ++ticks_;
}

void Recorder::check(std::uint64_t hash) {
    const bool isChecked = !replay.checkpoints.empty() && replay.checkpoints.back().tick == ticks_;
    if (!isChecked && !full_ && replay.checkpoints.size() < Replay::kMaxCheckpoints)
        replay.checkpoints.push_back({ticks_, hash});
}

const InputFrame* ReplayPlayer::next() {
    while (run_ < replay_->runs.size() && inRun_ == replay_->runs[run_].ticks) {
        ++run_;
        inRun_ = 0;
    }
    if (run_ == replay_->runs.size()) return nullptr;
    ++inRun_;
    ++tick_;
    return &replay_->runs[run_].frame;
}

const HashCheck* ReplayPlayer::checkpoint() const {
    const auto at =
        std::lower_bound(replay_->checkpoints.begin(), replay_->checkpoints.end(), tick_,
                         [](const HashCheck& check, std::uint64_t tick) { return check.tick < tick; });
    return at != replay_->checkpoints.end() && at->tick == tick_ ? &*at : nullptr;
}

}  // namespace plumb
