#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/player_options.hpp"
#include "app/recording/crash_file.hpp"
#include "core/watchdog.hpp"
#include "ecs/world.hpp"
#include "input/recorder.hpp"
#include "input/replay_link.hpp"

namespace plumb {

/// What is kept of a running game so that the run can be repeated: the file of --record, a link, the report
/// of a crash.
class RunRecords {
public:
    /// How the game runs, which decides what is kept without an option.
    struct Setting {
        bool inWindow = false;             ///< not headless
        bool played = false;               ///< by a person: a crash leaves a report in `folder`
        bool onPage = false;               ///< of a browser, which offers a link
        Path folder;                       ///< for what the game keeps on this computer
        const Replay* replayed = nullptr;  ///< the replay that is played; null: none. Must outlive this
    };

    /// To be called before the first tick.
    /// @param start  project, engine, scene, seed and keys
    /// @return false, with an error in the log, if a file that the options name cannot be created
    bool begin(const PlayerOptions& options, const Replay& start, const Setting& setting);

    /// To be called before each tick, with its input: the records contain the tick in which the game crashes.
    void tickBegins(const InputFrame& input);
    /// To be called after each tick.
    void tickEnds(const World& world);
    /// To be called after the last tick.
    void end(const World& world);

    /// To be called when the run is changed by something else than input: from here on, a replay would
    /// differ. The recording and the link end; the report of a crash says it.
    /// @param why   for people: a sentence in the past tense, without a full stop
    /// @param hash  that of the world after the last tick, before the change
    void changed(const std::string& why, std::uint64_t hash);
    /// To be called when a saved game is loaded: the report of a crash begins with it. A recording and a link
    /// end, as changed() says.
    /// @param state  the file
    /// @param keys   the changes of the bindings, see Replay
    void loaded(std::string state, std::string keys, std::uint64_t hash);
    /// True while a recording or a link repeats the run exactly, which changed() would end.
    [[nodiscard]] bool exact() const { return recording_.has_value() || link_.has_value(); }

    /// @param hash  that of the world after the last tick; none if it is unknown
    /// @error the run has no link
    [[nodiscard]] Result<std::string> link(std::optional<std::uint64_t> hash) const;
    [[nodiscard]] bool failed() const { return failed_; }  ///< the recording could not be written

private:
    bool beginCrashFile(const PlayerOptions& options, const Setting& setting);
    void endRecording(const std::string& why, std::uint64_t hash);
    void closeRecording(const std::string& why);
    void updateRecording();

    Recorder recorder_;
    std::optional<RecordingFile> recording_;  // empty: the game is not recorded, or no longer
    std::string recordingName_;
    std::optional<CrashFile> crashFile_;  // empty: a crash leaves no file
    Path crashFolder_;
    std::string crashSettings_;
    std::optional<Watchdog> watchdog_;
    std::optional<LinkWriter> link_;  // empty: no link can be asked for, or no longer
    std::string whyNoLink_;
    std::int64_t recorded_ = 0;  // ticks since begin()
    std::int64_t ticks_ = 0;     // of the report of a crash
    bool failed_ = false;
};

}  // namespace plumb
