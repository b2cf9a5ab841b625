#include "input/recorder.hpp"

#include <algorithm>

namespace plumb {

std::uint64_t Replay::ticks() const {
    std::uint64_t count = 0;
    for (const InputRun& run : runs) count += run.ticks;
    return count;
}

void Recorder::record(const InputFrame& frame) {
    if (ticks_ == Replay::kMaxTicks) return;
    const bool same = !replay.runs.empty() && replay.runs.back().frame == frame;
    if (!same && replay.runs.size() == Replay::kMaxRuns) return;
    if (!same) replay.runs.push_back({frame, 0});
    ++replay.runs.back().ticks;
    ++ticks_;
}

void Recorder::check(std::uint64_t hash) {
    const bool isChecked = !replay.checkpoints.empty() && replay.checkpoints.back().tick == ticks_;
    if (!isChecked && replay.checkpoints.size() < Replay::kMaxCheckpoints)
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
