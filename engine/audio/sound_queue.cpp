#include "audio/sound_queue.hpp"

#include <algorithm>

namespace plumb {

SoundQueue::SoundQueue() {
    waiting_.reserve(64);
    passed_.reserve(kMaxRemembered);
}

void SoundQueue::add(const SoundEvent& event) {
    if (event.sound.empty()) return;
    if (event.tick + kMemory < newest_) reset();
    newest_ = std::max(newest_, event.tick);
    const auto same = [&](const Passed& passed) {
        return passed.tick == event.tick && passed.sound == event.sound.path.value;
    };
    if (std::any_of(passed_.begin(), passed_.end(), same)) return;
    const Passed passed{event.tick, event.sound.path.value};
    if (passed_.size() < kMaxRemembered) {
        passed_.push_back(passed);
    } else {
        passed_[oldest_] = passed;
        oldest_ = (oldest_ + 1) % kMaxRemembered;
    }
    waiting_.push_back(event);
}

void SoundQueue::reset() {
    waiting_.clear();
    passed_.clear();
    oldest_ = 0;
    newest_ = 0;
}

}  // namespace plumb
