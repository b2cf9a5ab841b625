#pragma once

#include <memory>
#include <string>

#include "ecs/snapshot.hpp"
#include "editor/model/play/play_mode.hpp"

namespace plumb::editor {

class Workspace;

/// A hidden copy of the game, simulated to predict what will happen. The copy is reused, because creating one
/// loads the assets of the game.
class GhostGame {
public:
    /// Returns a copy of the running game in its present state; if no game runs, in the initial state of the
    /// scene.
    /// @return  null if the scene cannot be played
    PlaySession* now(Workspace& workspace);
    /// Returns a copy of the running game in its state after a recorded tick.
    /// @pre  a game runs, and `tick` is in its recording
    PlaySession* at(Workspace& workspace, std::int64_t tick);
    /// Advances the copy from `tick` to the next recorded tick.
    /// @pre  the copy is in the state after `tick`: after `at(tick)`, or after `playRecorded(tick - 1)`
    void playRecorded(const Workspace& workspace, std::int64_t tick);
    void clear() { session_.reset(), snapshot_.reset(); }

private:
    PlaySession* fresh(Workspace& workspace);

    std::unique_ptr<PlaySession> session_;
    std::unique_ptr<Snapshot> snapshot_;
    std::string scene_;
};

/// Returns the entity with this ObjectId, by a linear search; a null id if the world has none.
EntityId entityIn(const World& world, ObjectId id);

}  // namespace plumb::editor
