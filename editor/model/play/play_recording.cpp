#include "editor/model/play/play_recording.hpp"

#include <algorithm>
#include <utility>

#include "core/assert.hpp"
#include "ecs/world.hpp"
#include "physics/simulation.hpp"
#include "scene/particles.hpp"
#include "scene/physics/physics_state.hpp"
#include "script/script_state.hpp"

namespace plumb::editor {
namespace {

/// Initial distance of keyframes: a step back replays at most this many ticks. Larger distances save memory.
constexpr std::int64_t kSpacing = 15;  // ticks

constexpr std::size_t kParticleBytes = 9 * sizeof(float);  // size of one particle in all arrays together

/// Estimates the size of a keyframe. Tile grids and texts are copied on write, so they are not counted.
std::size_t bytesOf(const Snapshot& snapshot, const World& world) {
    const auto* physics = world.findResource<PhysicsState>();
    const auto* particles = world.findResource<Particles>();
    const auto* scripts = world.findResource<ScriptState>();
    return snapshot.byteCount() + (physics == nullptr ? 0 : physics::stateBytes(physics->world)) +
           (particles == nullptr ? 0 : particles->x.size() * kParticleBytes) +
           (scripts == nullptr ? 0 : scripts->memory.bytes());
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
    if (now % spacing_ == 0 && keyframes_.back().tick < now) keep(now, world);
    // The oldest keyframe is removed as soon as the second oldest covers the whole time to rewind.
    while (keyframes_.size() > 1 && keyframes_[1].tick <= now - kTicks) {
        drop(keyframes_.front());
        keyframes_.pop_front();
    }
    while (first_ < keyframes_.front().tick) inputs_.pop_front(), ++first_;
}

void PlayRecording::cut(std::int64_t tick) {
    PLUMB_ASSERT(tick >= first_, "tick to cut at is before the start of the recording");
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

/// Doubles the distance of the keyframes; the first and the last one stay.
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
