#include "editor/model/play/play_recording.hpp"

#include <algorithm>
#include <utility>

#include "core/assert.hpp"
#include "ecs/world.hpp"
#include "physics/simulation.hpp"
#include "scene/particles.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb::editor {
namespace {

/// A step back plays at most this many ticks again; worlds that are kept more rarely cost less to keep.
constexpr std::int64_t kSpacing = 15;  // ticks

constexpr std::size_t kParticleBytes = 9 * sizeof(float);  // of one, in all arrays

/// About what a kept world takes. Tile grids and texts are shared by all of them until they are changed.
std::size_t bytesOf(const Snapshot& snapshot, const World& world) {
    const auto* physics = world.findResource<PhysicsState>();
    const auto* particles = world.findResource<Particles>();
    return snapshot.byteCount() + (physics == nullptr ? 0 : physics::stateBytes(physics->world)) +
           (particles == nullptr ? 0 : particles->x.size() * kParticleBytes);
}

}  // namespace

void PlayRecording::begin(std::int64_t tick, const World& world) {
    clear();
    first_ = tick;
    spacing_ = kSpacing;
    keep(tick, world);
}

void PlayRecording::clear() {
    keyframes_.clear();
    inputs_.clear();
    spare_.clear();
    bytes_ = 0;
    first_ = 0;
}

void PlayRecording::tickDone(const World& world) {
    const std::int64_t now = newest();
    if (now % spacing_ == 0) keep(now, world);
    // The oldest kept world goes once the next one is old enough to begin with.
    while (keyframes_.size() > 1 && keyframes_[1].tick <= now - kTicks) {
        drop(keyframes_.front());
        keyframes_.pop_front();
    }
    while (first_ < keyframes_.front().tick) inputs_.pop_front(), ++first_;
}

void PlayRecording::cut(std::int64_t tick) {
    PLUMB_ASSERT(tick >= first_, "nothing is cut off before the recording begins");
    while (newest() > tick) inputs_.pop_back();
    while (keyframes_.back().tick > tick) {
        drop(keyframes_.back());
        keyframes_.pop_back();
    }
}

std::int64_t PlayRecording::oldest() const { return std::max(first_, newest() - kTicks); }

const PlayRecording::Keyframe& PlayRecording::before(std::int64_t tick) const {
    const auto after =
        std::upper_bound(keyframes_.begin(), keyframes_.end(), tick,
                         [](std::int64_t t, const Keyframe& keyframe) { return t < keyframe.tick; });
    PLUMB_ASSERT(after != keyframes_.begin(), "this tick is older than the recording");
    return *std::prev(after);
}

void PlayRecording::keep(std::int64_t tick, const World& world) {
    std::unique_ptr<Snapshot> snapshot;
    if (spare_.empty()) {
        snapshot = std::make_unique<Snapshot>();
    } else {
        snapshot = std::move(spare_.back());
        spare_.pop_back();
    }
    world.save(*snapshot);
    const std::size_t bytes = bytesOf(*snapshot, world);
    bytes_ += bytes;
    keyframes_.push_back({tick, bytes, std::move(snapshot)});
    if (bytes_ > kBytes) thin();
}

void PlayRecording::drop(Keyframe& keyframe) {
    bytes_ -= keyframe.bytes;
    if (spare_.size() < 4) spare_.push_back(std::move(keyframe.world));
}

/// Twice as far apart; the first and the last stay.
void PlayRecording::thin() {
    spacing_ *= 2;
    std::deque<Keyframe> rest;
    for (Keyframe& keyframe : keyframes_) {
        const bool ends = &keyframe == &keyframes_.front() || &keyframe == &keyframes_.back();
        if (ends || keyframe.tick % spacing_ == 0) {
            rest.push_back(std::move(keyframe));
        } else {
            drop(keyframe);
        }
    }
    keyframes_ = std::move(rest);
    spare_.clear();
}

}  // namespace plumb::editor
