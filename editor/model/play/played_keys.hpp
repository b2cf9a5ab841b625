#pragma once

#include "ecs/world.hpp"
#include "editor/model/play/play_edits.hpp"
#include "input/action_map.hpp"

namespace plumb::editor {

class Workspace;

// Keys that are changed while a game plays count from its next tick on that was not played before. That is a
// change by hand like others: it is played again at its tick, so that the past stays what it was.

/// What keys mean from now on, for the game that plays.
void wantKeys(Workspace& workspace, const ActionMap& keys);
/// To be called in every frame: a game that goes on from the past gets the keys that are wanted now.
void tendKeys(Workspace& workspace);
/// The next game begins with the keys of its project.
void forgetKeys(Workspace& workspace);

/// Whether a change by hand is one of keys.
bool isOfKeys(const PlayEdit& edit);
void writeKeys(World& world, const PlayEdit& edit);

}  // namespace plumb::editor
