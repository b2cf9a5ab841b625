#pragma once

#include <string_view>

#include "core/result.hpp"

namespace plumb {
struct Replay;
}

namespace plumb::editor {

class Workspace;

/// Checks what playReplayInScene() needs to know of a replay.
/// @error recorded by another project, or begins with a saved game
Result<Done> checkReplay(const Workspace& workspace, const Replay& replay, std::string_view file);

/// Plays a replay in the open scene up to 2 s before its end and pauses there; "Watch the recording" plays
/// the rest. The tick in which the recorded game crashed is left out, as it would crash the editor.
/// @param file  name of the replay, for messages
/// @pre the scene with which the replay begins is open
/// @error recorded by another project; the scene cannot be played; the state differs from a recorded hash
Result<Done> playReplayInScene(Workspace& workspace, const Replay& replay, std::string_view file);

}  // namespace plumb::editor
