#pragma once

#include <memory>
#include <string>

#include "ecs/snapshot.hpp"
#include "editor/model/play/play_mode.hpp"

namespace plumb::editor {

class Workspace;

/// A hidden copy of the game, to find out what would happen. Kept, because making one reads the
/// assets of the game.
class GhostGame {
public:
    /// As the game is now; while it does not run, as it would begin.
    /// @return  null when the scene cannot be played
    PlaySession* now(Workspace& workspace);
    /// As it was after a recorded tick. @pre the game plays, and has that tick
    PlaySession* at(Workspace& workspace, std::int64_t tick);
    /// One recorded tick after that. @pre `at` or this brought it to that tick
    void playRecorded(const Workspace& workspace, std::int64_t tick);
    void clear() { session_.reset(), snapshot_.reset(); }

private:
    PlaySession* fresh(Workspace& workspace);

    std::unique_ptr<PlaySession> session_;
    std::unique_ptr<Snapshot> snapshot_;
    std::string scene_;
};

/// The entity of a world that has this lasting id.
EntityId entityIn(const World& world, ObjectId id);

}  // namespace plumb::editor
