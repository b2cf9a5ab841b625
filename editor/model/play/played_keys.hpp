#pragma once

#include "ecs/world.hpp"
#include "editor/model/play/play_edits.hpp"
#include "input/action_map.hpp"

namespace plumb::editor {

class Workspace;

// Key bindings changed while a game runs take effect from the next tick that is not a replay. The change is
// stored as a `PlayEdit` of that tick, so that replaying earlier and later ticks gives the same result.

/// Sets the key bindings of the running game. No effect if no game runs.
void setPlayedKeys(Workspace& workspace, const ActionMap& keys);
/// Must be called in every frame: a game continued from the past gets the bindings set by `setPlayedKeys`.
void updatePlayedKeys(Workspace& workspace);
/// Discards the bindings set by `setPlayedKeys`: the next game starts with those of its project.
void clearPlayedKeys(Workspace& workspace);

/// True if `edit` stores a change of the key bindings, not of a component field.
bool isOfKeys(const PlayEdit& edit);
/// Applies a change of the key bindings to the input of a game's world.
void writeKeys(World& world, const PlayEdit& edit);

}  // namespace plumb::editor
