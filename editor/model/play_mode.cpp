#include "editor/model/play_mode.hpp"

#include <algorithm>
#include <utility>

#include "ecs/world.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

constexpr double kTick = 1.0 / 60.0;    // s
constexpr double kLongestFrame = 0.25;  // s; what is longer slows the game down instead of piling up ticks

}  // namespace

void PlayMode::start(std::unique_ptr<PlaySession> session) {
    session_ = std::move(session);
    indexed_ = -1;
    paused_ = false;
    ticks_ = 0;
    rest_ = 0.0;
}

void PlayMode::stop() {
    session_.reset();
    paused_ = false;
}

EntityId PlayMode::find(ObjectId id) const {
    if (!running()) return {};
    const World& played = world();
    const auto known = entities_.find(id.value);
    if (known != entities_.end() && indexed_ >= 0 && idOf(known->second) == id) return known->second;
    if (indexed_ == ticks_) return {};
    indexed_ = ticks_;
    entities_.clear();
    played.each<const SceneEntity>(
        [&](EntityId entity, const SceneEntity& part) { entities_[part.id] = entity; });
    const auto found = entities_.find(id.value);
    return found == entities_.end() ? EntityId{} : found->second;
}

ObjectId PlayMode::idOf(EntityId entity) const {
    const SceneEntity* part = running() ? std::as_const(world()).find<SceneEntity>(entity) : nullptr;
    return part == nullptr ? ObjectId{} : ObjectId{part->id};
}

float PlayMode::advance(double seconds, const InputFrame& input) {
    if (!running() || paused_) return 1.0f;
    rest_ += std::clamp(seconds, 0.0, kLongestFrame);
    for (; rest_ >= kTick; rest_ -= kTick) {
        step(input);
    }
    return static_cast<float>(rest_ / kTick);
}

void PlayMode::step(const InputFrame& input) {
    if (!running()) return;
    session_->tick(input);
    ++ticks_;
}

}  // namespace plumb::editor
