#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ecs/snapshot.hpp"
#include "editor/model/debug/breakpoints.hpp"
#include "editor/model/debug/quiet_scripts.hpp"
#include "script/script_frames.hpp"
#include "script/script_observer.hpp"

namespace plumb {
class World;
}

namespace plumb::editor {

/// A place in time: the simulation is deterministic, so the lines of scripts that a tick runs can be counted.
struct Moment {
    std::int64_t tick = 0;
    int line = 0;  ///< number of the line among all that run in this tick, from 1; it is about to run

    friend auto operator<=>(const Moment&, const Moment&) = default;
};

/// The line of a script at which the game has stopped.
struct Halt {
    Moment moment;
    std::string file;
    int line = 0;
    int depth = 0;    ///< number of functions being called
    int handler = 0;  ///< number of the handler in its tick
    EntityId entity;
    TypeKey script = 0;               ///< component type of the script
    std::vector<ScriptFrame> frames;  ///< innermost first
    std::string problem;              ///< why the condition of the breakpoint has no value; empty: it has one
};

/// A field of an entity's component.
struct WatchedField {
    EntityId entity;
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;

    /// Returns the bytes of the value; none if the entity has no such component.
    [[nodiscard]] std::vector<std::byte> read(const World& world) const;
};

/// Where a tick is to be stopped. Lines up to the moment `after` are passed.
struct LineGoal {
    enum class Kind : unsigned char {
        Breakpoints,  ///< at breakpoints only
        Into,         ///< at the next line
        Over,         ///< at the next line of the same function or of its caller, and at breakpoints
        Out,          ///< at the next line of the caller, and at breakpoints
        Line,         ///< at the line of this number
        Count         ///< nowhere
    };
    Kind kind = Kind::Breakpoints;
    Moment after;
    int depth = 0;       ///< of the line at `after`
    int handler = 0;     ///< of the line at `after`
    int line = 0;        ///< for Kind::Line
    WatchedField field;  ///< its changes are noted; no type: of no field
};

/// Watches the lines of one tick at a time and stops it at its goal.
class LineWatch final : public ScriptObserver {
public:
    /// What has changed the watched field last.
    struct Change {
        int line = 0;  ///< number of the line; 0: not a line of a script
    };

    explicit LineWatch(const Breakpoints& breakpoints) : breakpoints_{breakpoints} {}

    /// To be called before a tick.
    /// @param quiet  number of the first line whose log lines are shown; those before were logged already
    void begin(World& world, std::int64_t tick, const LineGoal& goal, int quiet);
    /// To be called after the tick.
    void end();

    /// Where the tick was stopped; null: it has run to its end.
    [[nodiscard]] const Halt* halt() const { return halt_ ? &*halt_ : nullptr; }
    /// The world at that place.
    [[nodiscard]] const Snapshot& middle() const { return middle_; }
    [[nodiscard]] int lines() const { return lines_; }  ///< number of lines that the tick has run
    [[nodiscard]] const std::optional<Change>& change() const { return change_; }

    [[nodiscard]] bool watches() const override { return world_ != nullptr; }
    [[nodiscard]] bool abandons() const override { return halt_.has_value(); }
    void handlerBegins(EntityId entity, TypeKey script) override;
    bool onLine(lua_State* coroutine, const char* file, int line, int depth) override;
    void handlerEnds() override { noteChange(lines_); }

private:
    [[nodiscard]] bool isGoal(int depth) const;
    [[nodiscard]] bool isBreakpoint(lua_State* coroutine, const char* file, int line);
    void stop(lua_State* coroutine, const char* file, int line, int depth);
    void noteChange(int madeBy);

    const Breakpoints& breakpoints_;
    World* world_ = nullptr;  // of the tick that runs; null: none runs
    LineGoal goal_;
    std::int64_t tick_ = 0;
    int lines_ = 0;
    int handlers_ = 0;  // handlers that have begun in this tick
    EntityId entity_;   // of the handler that runs
    TypeKey script_ = 0;
    int quiet_ = 0;
    std::string problem_;  // of the condition that was evaluated last
    std::optional<Halt> halt_;
    Snapshot middle_;
    std::vector<std::byte> value_;  // of the watched field
    std::optional<Change> change_;
    std::optional<QuietScripts> log_;
};

}  // namespace plumb::editor
