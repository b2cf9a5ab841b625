#include "editor/model/play/play_mode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ecs/world.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

constexpr double kTick = 1.0 / 60.0;    // s: duration of a tick
constexpr double kLongestFrame = 0.25;  // s: longer frames slow the game down, so that ticks do not pile up
constexpr double kMostTicks = 4.0;      // maximum ticks per frame, times the speed factor; at least 15

}  // namespace

void PlayMode::start(std::unique_ptr<PlaySession> session, bool paused) {
    session_ = std::move(session);
    indexed_ = -1;
    paused_ = paused;
    replaying_ = false;
    ticks_ = 0;
    rest_ = 0.0;
    edits_.clear();
    recording_.begin(0, world());
}

void PlayMode::stop() {
    session_.reset();
    recording_.clear();
    paused_ = replaying_ = false;
}

void PlayMode::contentChanged(const GameContent& content, const ContentChange& change) {
    session_->contentChanged(content, change);
    replaying_ = false;
    edits_.clear();
    recording_.begin(ticks_, world());
}

EntityId PlayMode::find(ObjectId id) const {
    if (!running()) return {};
    const World& played = world();
    const EntityId* known = entities_.find(id.value);
    if (known != nullptr && indexed_ >= 0 && idOf(*known) == id) return *known;
    if (indexed_ == ticks_) return {};
    indexed_ = ticks_;
    entities_.clear();
    played.each<const SceneEntity>([&](EntityId entity, const SceneEntity& part) {
        if (part.id != 0) entities_.set(part.id, entity);
    });
    const EntityId* found = entities_.find(id.value);
    return found == nullptr ? EntityId{} : *found;
}

ObjectId PlayMode::idOf(EntityId entity) const {
    const SceneEntity* part = running() ? std::as_const(world()).find<SceneEntity>(entity) : nullptr;
    return part == nullptr ? ObjectId{} : ObjectId{part->id};
}

float PlayMode::advance(double seconds, const InputFrame& input) {
    if (!running() || paused_) return 1.0f;
    const double speed = std::exp2(speed_);
    rest_ += std::clamp(seconds, 0.0, kLongestFrame) * speed;
    // On a machine that is too slow the game runs slower, instead of blocking the editor.
    rest_ = std::min(rest_, kTick * std::max(kLongestFrame / kTick, kMostTicks * speed));
    for (; rest_ >= kTick && !paused_; rest_ -= kTick) {
        step(input);
    }
    return paused_ ? 1.0f : static_cast<float>(rest_ / kTick);
}

void PlayMode::step(const InputFrame& input) {
    if (!running()) return;
    if (inPast()) {
        playRecorded();
        if (replaying_ && !inPast()) paused_ = true, replaying_ = false;
        return;
    }
    recording_.record(input);
    tick(input, false);
    recording_.tickDone(world());
    edits_.forgetBefore(recording_.keyframes().front().tick);
}

void PlayMode::setPaused(bool paused) {
    if (!running() || paused == paused_) return;
    paused_ = paused;
    replaying_ = false;
    rest_ = 0.0;
    if (!paused && inPast()) branch();
}

void PlayMode::setSpeed(int power) { speed_ = std::clamp(power, kSlowest, kFastest); }

void PlayMode::seek(std::int64_t tick) {
    if (!running()) return;
    paused_ = true;
    replaying_ = false;
    rest_ = 0.0;
    tick = std::clamp(tick, oldest(), newest());
    if (tick == ticks_) return;
    const PlayRecording::Keyframe& keyframe = recording_.before(tick);
    if (tick < ticks_ || keyframe.tick > ticks_) {
        world().restore(*keyframe.world);
        session_->restored();
        ticks_ = keyframe.tick;
        indexed_ = -1;
        edits_.replay(world(), *this, ticks_);
    }
    while (ticks_ < tick) playRecorded();
}

void PlayMode::playReplay() {
    if (!inPast()) return;
    paused_ = false;
    replaying_ = true;
    rest_ = 0.0;
}

void PlayMode::edit(ObjectId object, const TypeInfo& type, const FieldInfo& field, const FieldValue& value) {
    if (!running()) return;
    const PlayEdit edit{ticks_, object, &type, &field, value};
    if (!writePlayed(world(), *this, edit)) return;
    branch();
    edits_.add(edit);
}

void PlayMode::tick(const InputFrame& input, bool again) {
    if (tickListener != nullptr) tickListener->before(world());
    session_->tick(input);
    ++ticks_;
    if (tickListener != nullptr) tickListener->after(world(), ticks_, again);
}

/// Replays the next recorded tick with its input and the user's changes.
void PlayMode::playRecorded() {
    tick(recording_.inputAfter(ticks_), true);
    edits_.replay(world(), *this, ticks_);
}

/// Discards the recorded ticks after the present one.
void PlayMode::branch() {
    recording_.cut(ticks_);
    edits_.cut(ticks_);
    replaying_ = false;
}

}  // namespace plumb::editor
