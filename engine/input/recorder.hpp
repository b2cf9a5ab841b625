#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "input/input_frame.hpp"

namespace plumb {

/// The same input for a number of ticks.
struct InputRun {
    InputFrame frame;
    std::uint64_t ticks = 0;

    friend bool operator==(const InputRun&, const InputRun&) = default;
};

/// The hash of the world after a tick, to find the first tick in which a replay differs.
struct HashCheck {
    std::uint64_t tick = 0;
    std::uint64_t hash = 0;

    friend bool operator==(const HashCheck&, const HashCheck&) = default;
};

/// How a recorded game crashed, as its report says.
struct RecordedCrash {
    std::string what;     ///< the signal and what it means, or the assertion; empty: the game did not crash
    std::string running;  ///< the system or handler; empty: none
    std::string build;    ///< of the program, see buildId()

    friend bool operator==(const RecordedCrash&, const RecordedCrash&) = default;
};

/// A recorded game: its initial state and the input of every tick. Its file `*.replay` is text, with one line
/// for each change of the input; that of a crash contains the input in packed form, see PackedInput.
struct Replay {
    static constexpr int kFormat = 2;  ///< that of a crash; 1: without packed input and crash, of recordings
    static constexpr std::uint64_t kMaxTicks = std::uint64_t{60} * 3600 * 24;  ///< 24 hours at 60 Hz
    static constexpr std::size_t kMaxRuns = std::size_t{1} << 20;
    static constexpr std::size_t kMaxCheckpoints = std::size_t{1} << 20;
    static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

    std::string project;     ///< name of the project
    std::string engine;      ///< version of the engine that recorded it
    std::string scene;       ///< path of the first scene
    std::string keys;        ///< changes of the bindings by the player, as JSON; empty for none
    std::string state;       ///< of a crash: the saved game that it begins with; empty: the scene
    std::uint64_t seed = 1;  ///< in a file without one, that of a game without --seed
    std::vector<InputRun> runs;
    std::vector<HashCheck> checkpoints;  ///< in ascending order of ticks
    RecordedCrash crash;                 ///< read, never written, as the game crashes while it is written

    [[nodiscard]] std::uint64_t ticks() const;

    friend bool operator==(const Replay&, const Replay&) = default;
};

/// True if devices can give this input: a bit that is set belongs to a key, a button, a gamepad or a slot.
[[nodiscard]] bool isPossible(const InputFrame& frame);

/// Records the input of a running game. Allocates only when the input changes.
class Recorder {
public:
    Replay replay;  ///< the caller sets project, engine, scene and seed

    /// Records the input of the next tick. Does nothing from the first tick on that exceeds the limits of a
    /// Replay.
    void record(const InputFrame& frame);

    /// Records the world's hash after the last tick. Does nothing if that was not recorded.
    void check(std::uint64_t hash);

    [[nodiscard]] std::uint64_t ticks() const { return ticks_; }
    [[nodiscard]] bool full() const { return full_; }  ///< ticks were not recorded

private:
    std::uint64_t ticks_ = 0;
    bool full_ = false;
};

/// Returns the frames of a replay, one per tick.
class ReplayPlayer {
public:
    /// @param replay  must outlive this
    explicit ReplayPlayer(const Replay& replay) : replay_{&replay} {}

    /// Returns the input of the next tick; null at the end.
    const InputFrame* next();

    /// The recorded hash after the tick last returned by next(); null if there is none.
    [[nodiscard]] const HashCheck* checkpoint() const;

    [[nodiscard]] std::uint64_t tick() const { return tick_; }  ///< number of frames returned by next()

private:
    const Replay* replay_;
    std::size_t run_ = 0;      // index of the current run
    std::uint64_t inRun_ = 0;  // ticks of that run that next() has returned
    std::uint64_t tick_ = 0;
};

std::string writeReplay(const Replay& replay);

/// @error  not a replay, a newer format, an exceeded limit, or an invalid line; with the line number
Result<Replay> parseReplay(std::string_view text, std::string_view where);

/// The file of a recording in progress. It is a whole replay after every update(), so that a crash of the
/// program loses none of it.
class RecordingFile {
public:
    /// Replaces the file, atomically, by a replay without ticks. Creates missing folders.
    /// @error the file cannot be written
    static Result<RecordingFile> create(const Path& path, const Replay& replay);

    /// Writes what was recorded since the last call, over the end of the file. Allocates memory only when the
    /// input has changed or a hash was recorded.
    /// @error the file cannot be written, e.g. the disk is full: it is again what it was before the call, and
    /// the error says how many ticks it has. Do not call update() again after an error.
    Result<Done> update(const Recorder& recorder);

private:
    using Handle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

    RecordingFile(Path path, Handle file, std::string_view header);
    bool write(std::string_view text);
    bool restoreEnd();

    Path path_;
    Handle file_;
    long final_;               // bytes from the file's start that do not change any more
    std::string end_;          // the file's text after the final part
    std::uint64_t ticks_ = 0;  // number of ticks in the file
    std::size_t runs_ = 0;     // number of runs in the file; all but the last are final
    std::size_t checks_ = 0;   // number of checkpoints in the file
    std::string changes_;      // changes of the input of the last run, as text
    std::string text_;         // next text after the final part; a member, so that its memory is reused
};

Result<Replay> loadReplay(const Path& path);

}  // namespace plumb
