#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/player_options.hpp"
#include "input/input.hpp"
#include "input/recorder.hpp"

namespace plumb {

// The replay that the options of a program name: a file or a link.

[[nodiscard]] bool isReplayed(const PlayerOptions& options);

/// For messages: the name of the file, or "link".
[[nodiscard]] std::string nameOfReplay(const PlayerOptions& options);

/// @error it cannot be read
Result<Replay> replayOf(const PlayerOptions& options);

/// True for a run that people play: in a window, until it is closed.
[[nodiscard]] bool isPlayedLive(const PlayerOptions& options);

/// Returns `options` with the scene and the seed of the run. Those of a replay are in it; a file without
/// these lines has those of a run without options. A run that is played live has another seed each time.
/// @param projectName  the project to play; recordings of another one are refused
/// @error the replay cannot be read, or belongs to another project
Result<PlayerOptions> begun(PlayerOptions options, std::string_view projectName);

/// Binds the keys as they were when the replay was recorded. What cannot be bound is logged.
/// @error its keys are no JSON
Result<Done> useReplayedKeys(Input& input, const Replay& replay, const std::string& where);

/// Says that the report of a crash has been replayed to its end without that crash. Nothing for other
/// replays.
void noteEndOfCrash(const Replay& replay, std::int64_t ticks);

}  // namespace plumb
