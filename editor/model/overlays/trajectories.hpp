#pragma once

#include <vector>

#include "editor/model/overlays/ghost_game.hpp"

namespace plumb::editor {

/// The ways of things: where they came along in the last second, and where they go in the next two if the
/// hands stay as they are. Played by a copy of the game, so walls, springs and wind count. While it does not
/// run, it is how the scene would begin.
class Trajectories {
public:
    static constexpr int kBehind = 60;        ///< ticks
    static constexpr int kAhead = 120;        ///< ticks
    static constexpr double kBudget = 0.003;  ///< s of CPU in a frame

    struct Way {
        ObjectId object;
        std::vector<Vec2> past;    ///< px, the last one is where it is
        std::vector<Vec2> future;  ///< px
    };

    /// To be called in every frame in which they are shown. While a game runs only its past is followed.
    /// @param all  of everything that moves; else of what is selected
    void tend(Workspace& workspace, bool all);
    void clear();
    [[nodiscard]] const std::vector<Way>& ways() const { return ways_; }
    [[nodiscard]] bool done() const { return ahead_ >= kAhead; }

private:
    struct Asked {
        bool playing = false;
        bool all = false;
        std::uint64_t revision = 0;   ///< of the document
        std::uint64_t selection = 0;  ///< its revision
        std::int64_t tick = 0;
        friend bool operator==(const Asked&, const Asked&) = default;
    };

    void choose(const Workspace& workspace, bool all);
    void begin(Workspace& workspace);
    void follow(const Workspace& workspace);
    void addPlaces(const World& world, bool future);
    void goOn(Workspace& workspace);

    GhostGame ghost_;
    PlaySession* game_ = nullptr;  // of the ghost; null while a game runs
    std::vector<Way> ways_;
    std::vector<EntityId> entities_;  // of them, in the ghost
    Asked asked_;
    bool begun_ = false;
    int ahead_ = kAhead;  // ticks played ahead
};

}  // namespace plumb::editor
