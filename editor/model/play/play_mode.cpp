#include "editor/model/play/play_mode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/assert.hpp"
#include "ecs/world.hpp"
#include "scene/components/scene_entity.hpp"
#include "script/script_state.hpp"

namespace plumb::editor {
namespace {

constexpr double kTick = 1.0 / 60.0;    // s: duration of a tick
constexpr double kLongestFrame = 0.25;  // s: longer frames slow the game down, so that ticks do not pile up
constexpr double kMostTicks = 4.0;      // maximum ticks per frame, times the speed factor; at least 15

}  // namespace

void PlayMode::start(std::unique_ptr<PlaySession> session, bool paused) {
    session_ = std::move(session);
    ++games_;
    indexed_ = -1;
    paused_ = paused;
    replaying_ = inside_ = false;
    beforeTick_ = {};
    ticks_ = 0;
    rest_ = 0.0;
    edits_.clear();
    recording_.begin(0, world());
}

void PlayMode::stop() {
    session_.reset();
    recording_.clear();
    paused_ = replaying_ = inside_ = false;
}

void PlayMode::contentChanged(const ContentChange& change) {
    PLUMB_ASSERT(!inside_, "leaveTick() before the content changes: a snapshot knows only the old types");
    session_->contentChanged(change);
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
    const bool goesOn = inside_;
    leaveTick();
    if (inPast()) {
        if (!tryTick(recording_.inputAfter(ticks_), true, goesOn)) return;
        finishRecorded();
        if (replaying_ && !inPast()) paused_ = true, replaying_ = false;
        return;
    }
    recording_.record(input);
    if (!tryTick(input, false, goesOn)) return;
    recording_.tickDone(world());
    edits_.forgetBefore(recording_.keyframes().front().tick);
}

void PlayMode::setPaused(bool paused) {
    if (!running() || paused == paused_) return;
    paused_ = paused;
    replaying_ = false;
    rest_ = 0.0;
    // The input of a tick that is stopped in its middle stays: the same tick goes on.
    if (!paused && inPast()) branch(inside_ ? ticks_ + 1 : ticks_);
}

void PlayMode::setSpeed(int power) { speed_ = std::clamp(power, kSlowest, kFastest); }

void PlayMode::seek(std::int64_t tick) {
    if (!running()) return;
    paused_ = true;
    replaying_ = false;
    rest_ = 0.0;
    leaveTick();
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
    leaveTick();
    const PlayEdit edit{ticks_, object, &type, &field, value};
    if (!writePlayed(world(), *this, edit)) return;
    branch(ticks_);
    edits_.add(edit);
}

void PlayMode::tick(const InputFrame& input, bool again) {
    if (tickListener != nullptr) tickListener->before(world());
    session_->tick(input);
    ++ticks_;
    if (tickListener != nullptr) tickListener->after(world(), ticks_, again);
}

/// As tick(), but the stopper may stop it. @return false if it did
bool PlayMode::tryTick(const InputFrame& input, bool again, bool goesOn) {
    if (tickStopper == nullptr || !tickStopper->begins(world(), ticks_ + 1, again, goesOn))
        return tick(input, again), true;
    world().save(beforeTick_);
    const std::int64_t before = ticks_;
    tick(input, again);
    const Snapshot* middle = tickStopper->ends();
    if (middle == nullptr) return true;
    ticks_ = before;
    enterTick(*middle);
    return false;
}

/// Shows the world in the middle of the next tick.
void PlayMode::enterTick(const Snapshot& middle) {
    // The Lua state in the middle of a call cannot be used, so that of the tick before is kept.
    world().restore(beforeTick_);
    const auto* scripts = world().findResource<ScriptState>();
    const ScriptState before = scripts == nullptr ? ScriptState{} : *scripts;
    world().restore(middle);
    world().resource<ScriptState>() = before;
    inside_ = paused_ = true;
    replaying_ = false;
    indexed_ = -1;
}

void PlayMode::leaveTick() {
    if (!inside_) return;
    inside_ = false;
    world().restore(beforeTick_);
    session_->restored();
    indexed_ = -1;
}

/// Replays the next recorded tick with its input and the user's changes.
void PlayMode::playRecorded() {
    tick(recording_.inputAfter(ticks_), true);
    finishRecorded();
}

void PlayMode::finishRecorded() {
    // A tick that was stopped in its middle has no keyframe yet.
    if (!inPast()) recording_.tickDone(world());
    edits_.replay(world(), *this, ticks_);
}

/// Discards the recorded input after a tick, and the changes after the present one.
void PlayMode::branch(std::int64_t lastInput) {
    recording_.cut(lastInput);
    edits_.cut(ticks_);
    replaying_ = false;
}

}  // namespace plumb::editor
