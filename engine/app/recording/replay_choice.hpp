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

/// Returns `options` with the scene and the seed of the replay that they name, if any; a file without these
/// lines has those of a run without options.
/// @param projectName  the project to play; recordings of another one are refused
/// @error the replay cannot be read, or belongs to another project
Result<PlayerOptions> begunAsRecorded(PlayerOptions options, std::string_view projectName);

/// Binds the keys as they were when the replay was recorded. What cannot be bound is logged.
/// @error its keys are no JSON
Result<Done> useReplayedKeys(Input& input, const Replay& replay, const std::string& where);

/// Says that the report of a crash has been replayed to its end without that crash. Nothing for other
/// replays.
void noteEndOfCrash(const Replay& replay, std::int64_t ticks);

}  // namespace plumb
