#include "editor/model/debug/script_debugger.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/text.hpp"
#include "ecs/world.hpp"

namespace plumb::editor {
namespace {

constexpr int kAll = std::numeric_limits<int>::max();  // number of a line after all lines

}  // namespace

ScriptDebugger::ScriptDebugger(PlayMode& play) : play_{play} { play_.tickStopper = this; }
ScriptDebugger::~ScriptDebugger() { play_.tickStopper = nullptr; }

// ---- ticks

bool ScriptDebugger::begins(World& world, std::int64_t tick, bool again, bool goesOn) {
    if (!again) logged_ = {tick, 0};
    LineGoal goal;
    if (command_) {
        goal = *command_;
    } else if (breakpoints.anyEnabled()) {
        // A game that goes on passes the line at which it was stopped.
        if (goesOn && watch_.halt() != nullptr) goal.after = watch_.halt()->moment;
    } else {
        if (tick >= logged_.tick) logged_ = {tick, kAll};
        return false;
    }
    const int quiet = tick < logged_.tick ? kAll : tick == logged_.tick ? logged_.line : 0;
    watch_.begin(world, tick, goal, quiet);
    return true;
}

const Snapshot* ScriptDebugger::ends() {
    watch_.end();
    const Halt* halt = watch_.halt();
    const Moment reached = halt != nullptr ? halt->moment : Moment{play_.ticks(), kAll};
    logged_ = std::max(logged_, reached);
    if (halt == nullptr) return nullptr;
    ++halts_;
    return &watch_.middle();
}

/// Runs the next tick to a goal.
void ScriptDebugger::runTick(const LineGoal& goal, const InputFrame& input) {
    command_ = goal;
    play_.step(input);
    command_.reset();
}

void ScriptDebugger::quietSeek(std::int64_t tick) {
    const QuietScripts quiet;
    play_.seek(tick);
}

/// The line at which the game is stopped, or a place after all lines of the present tick.
Moment ScriptDebugger::present() const {
    return halt() == nullptr ? Moment{play_.ticks(), kAll} : halt()->moment;
}

void ScriptDebugger::returnTo(Moment moment) {
    moment.line == kAll ? quietSeek(moment.tick) : static_cast<void>(goTo(moment));
}

// ---- commands

void ScriptDebugger::stepInto(const InputFrame& input) { step(LineGoal::Kind::Into, input); }
void ScriptDebugger::stepOver(const InputFrame& input) { step(LineGoal::Kind::Over, input); }
void ScriptDebugger::stepOut(const InputFrame& input) { step(LineGoal::Kind::Out, input); }

void ScriptDebugger::step(LineGoal::Kind kind, const InputFrame& input) {
    if (!play_.running()) return;
    notice_.clear();
    LineGoal goal{.kind = kind, .after = present()};
    if (const Halt* from = halt()) goal.depth = from->depth, goal.handler = from->handler;
    play_.setPaused(true);
    for (int i = 0; i < kMostTicks; ++i) {
        runTick(goal, input);
        if (halt() != nullptr) return;
    }
    notice_ = format("No script ran a line in {} ticks", kMostTicks);
}

void ScriptDebugger::stepBack() {
    if (!play_.running()) return;
    notice_.clear();
    const Moment from = present();
    play_.setPaused(true);
    if (halt() != nullptr && from.line > 1) return static_cast<void>(goTo({from.tick, from.line - 1}));
    const std::int64_t tick = halt() == nullptr ? from.tick + 1 : from.tick;
    if (const std::optional<Moment> last = lastLineBefore(tick)) return static_cast<void>(goTo(*last));
    returnTo(from);
    notice_ = "The recording has no earlier line of a script";
}

bool ScriptDebugger::goTo(Moment moment) {
    if (!play_.running() || moment.tick <= play_.oldest() || moment.tick > play_.newest()) return false;
    quietSeek(moment.tick - 1);
    runTick({.kind = LineGoal::Kind::Line, .line = moment.line});
    return halt() != nullptr;
}

/// Returns the last line that ran in a tick before this one.
std::optional<Moment> ScriptDebugger::lastLineBefore(std::int64_t tick) {
    // From keyframe to keyframe into the past, so that no tick runs twice.
    for (std::int64_t end = tick - 1; end > play_.oldest();) {
        const std::int64_t start = std::max(play_.recording().before(end - 1).tick, play_.oldest());
        std::optional<Moment> last;
        quietSeek(start);
        while (play_.ticks() < end) {
            runTick({.kind = LineGoal::Kind::Count});
            if (watch_.lines() > 0) last = Moment{play_.ticks(), watch_.lines()};
        }
        if (last) return last;
        end = start;
    }
    return std::nullopt;
}

// ---- changes of a field

bool ScriptDebugger::runBackToChange(const WatchedField& field) {
    if (!play_.running() || field.type == nullptr) return false;
    notice_.clear();
    const Moment from = present();
    play_.setPaused(true);
    const bool isInside = halt() != nullptr;
    std::optional<std::int64_t> tick;
    if (isInside) {
        // The lines of the present tick that have run already.
        quietSeek(from.tick - 1);
        runTick({.kind = LineGoal::Kind::Line, .line = from.line, .field = field});
        if (watch_.change()) tick = from.tick;
    }
    if (!tick) tick = tickOfChange(field, isInside ? from.tick - 1 : from.tick);
    if (!tick) {
        returnTo(from);
        notice_ = format("{} was not changed since tick {}", field.field->name, play_.oldest());
        return false;
    }
    const int end = isInside && *tick == from.tick ? from.line : 0;
    quietSeek(*tick - 1);
    runTick({.kind = end > 0 ? LineGoal::Kind::Line : LineGoal::Kind::Count, .line = end, .field = field});
    const int line = watch_.change() ? watch_.change()->line : 0;
    if (line > 0 && goTo({*tick, line})) {
        notice_ = format("This line changes {}", field.field->name);
    } else {
        quietSeek(*tick);
        notice_ = format("{} was changed in tick {}, but not by a script", field.field->name, *tick);
    }
    return true;
}

/// Returns the last tick up to `last` that has changed the field. Every tick is compared: a search by halves
/// would miss a value that has changed and come back.
std::optional<std::int64_t> ScriptDebugger::tickOfChange(const WatchedField& field, std::int64_t last) {
    const World& world = play_.world();
    for (std::int64_t end = last; end > play_.oldest();) {
        const std::int64_t start = std::max(play_.recording().before(end - 1).tick, play_.oldest());
        quietSeek(start);
        std::vector<std::byte> before = field.read(world);
        std::optional<std::int64_t> found;
        while (play_.ticks() < end) {
            quietSeek(play_.ticks() + 1);
            std::vector<std::byte> now = field.read(world);
            if (now != before) found = play_.ticks();
            before = std::move(now);
        }
        if (found) return found;
        end = start;
    }
    return std::nullopt;
}

// ---- errors

bool ScriptDebugger::canGoBackTo(std::int64_t tick) const {
    return play_.running() && tick >= play_.oldest() && tick <= play_.newest();
}

bool ScriptDebugger::goBackTo(std::int64_t tick) {
    if (!canGoBackTo(tick)) return false;
    play_.seek(tick);
    notice_ = "This is the tick before the error; a step goes to the first line after it";
    return true;
}

}  // namespace plumb::editor
