#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "editor/model/debug/line_watch.hpp"
#include "editor/model/play/play_mode.hpp"

namespace plumb::editor {

/// Stops the running game at lines of scripts, and steps through them forth and back. A line is reached by
/// running its tick from the beginning, which gives the same lines each time; so a step back is a run to the
/// line before.
class ScriptDebugger final : private TickStopper {
public:
    explicit ScriptDebugger(PlayMode& play);
    ~ScriptDebugger() override;
    ScriptDebugger(const ScriptDebugger&) = delete;
    ScriptDebugger& operator=(const ScriptDebugger&) = delete;

    Breakpoints breakpoints;

    /// The line at which the game is stopped; null: at none.
    [[nodiscard]] const Halt* halt() const { return play_.insideTick() ? watch_.halt() : nullptr; }
    /// What the last command did, if it is not obvious from the line.
    [[nodiscard]] const std::string& notice() const { return notice_; }
    /// Increases whenever the game stops at a line.
    [[nodiscard]] std::size_t halts() const { return halts_; }

    // Steps. Without a line at which the game is stopped, they begin at the present tick.

    /// Goes to the next line. @param input  for ticks that are not recorded
    void stepInto(const InputFrame& input);
    /// Goes to the next line, but runs functions that are called to their end.
    void stepOver(const InputFrame& input);
    /// Goes to the next line after the present function.
    void stepOut(const InputFrame& input);
    /// Goes to the line that ran before.
    void stepBack();
    /// Goes to a line. @return false if its tick is not recorded or runs fewer lines
    bool goTo(Moment moment);
    /// Goes to the line that has changed a field last, or to the tick if it was not a line of a script.
    /// @return false if the field was not changed in the recorded time
    bool runBackToChange(const WatchedField& field);

    /// Goes to the tick before an error. @param tick  tick of the log line
    /// @return false if it is not recorded
    bool goBackTo(std::int64_t tick);
    [[nodiscard]] bool canGoBackTo(std::int64_t tick) const;

private:
    /// Longest search for a line, forth and in one command.
    static constexpr int kMostTicks = 600;

    bool begins(World& world, std::int64_t tick, bool again, bool goesOn) override;
    const Snapshot* ends() override;

    void step(LineGoal::Kind kind, const InputFrame& input);
    void runTick(const LineGoal& goal, const InputFrame& input = {});
    void quietSeek(std::int64_t tick);
    [[nodiscard]] Moment present() const;
    [[nodiscard]] std::optional<Moment> lastLineBefore(std::int64_t tick);
    [[nodiscard]] std::optional<std::int64_t> tickOfChange(const WatchedField& field, std::int64_t last);
    void returnTo(Moment moment);

    PlayMode& play_;
    LineWatch watch_{breakpoints};
    std::optional<LineGoal> command_;  // of the tick that a command runs; none: the game plays
    Moment logged_;                    // lines before this one have written to the log
    std::size_t halts_ = 0;
    std::string notice_;
};

}  // namespace plumb::editor
