#pragma once

#include <vector>

#include "editor/model/overlays/ghost_game.hpp"

namespace plumb::editor {

/// The trajectories of entities: their positions in the last second, and those in the next two seconds if the
/// player's input stays the same. A copy of the game simulates them, so walls, springs and wind have their
/// effect. If no game runs, the simulation starts from the initial state of the scene.
class Trajectories {
public:
    static constexpr int kBehind = 60;        ///< ticks shown of the past
    static constexpr int kAhead = 120;        ///< ticks shown of the future
    static constexpr double kBudget = 0.003;  ///< s of CPU time per frame

    struct Way {  ///< the trajectory of one entity
        ObjectId object;
        std::vector<Vec2> past;    ///< px, world: one position per tick; the last one is the present
        std::vector<Vec2> future;  ///< px, world: one position per tick
    };

    /// Must be called in every frame in which trajectories are shown. While a game runs unpaused, only the
    /// past is recorded.
    /// @param all  true: of all moving entities; false: of the selected ones
    void update(Workspace& workspace, bool all);
    void clear();
    [[nodiscard]] const std::vector<Way>& ways() const { return ways_; }
    [[nodiscard]] bool done() const { return ahead_ >= kAhead; }

private:
    struct Asked {  ///< the state for which the trajectories were computed
        bool playing = false;
        bool all = false;
        std::uint64_t revision = 0;   ///< revision of the scene
        std::uint64_t selection = 0;  ///< revision of the selection
        std::int64_t tick = 0;
        friend bool operator==(const Asked&, const Asked&) = default;
    };

    void choose(const Workspace& workspace, bool all);
    void begin(Workspace& workspace);
    void follow(const Workspace& workspace);
    void addPlaces(const World& world, bool future);
    void goOn(Workspace& workspace);

    GhostGame ghost_;
    PlaySession* game_ = nullptr;  // owned by `ghost_`; null while a game runs unpaused
    std::vector<Way> ways_;
    std::vector<EntityId> entities_;  // entities in the world of the ghost, one per item of `ways_`
    Asked asked_;
    bool begun_ = false;  // false: nothing was computed since `clear`
    int ahead_ = kAhead;  // ticks of the future simulated so far
};

}  // namespace plumb::editor
