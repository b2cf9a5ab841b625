#pragma once

#include "editor/model/overlays/ghost_game.hpp"
#include "editor/model/overlays/jump_reach.hpp"

namespace plumb::editor {

/// Keeps the jump reach of the selected player up to date: recomputes it, spread over frames, after the scene
/// changed or the player stands in another position.
class ReachView {
public:
    static constexpr double kBudget = 0.004;  ///< s of CPU time per frame

    /// Must be called in every frame in which the jump reach is shown.
    /// @param anyPlayer  if no player is selected, takes the first player of the scene
    void update(Workspace& workspace, bool anyPlayer);
    void clear();

    [[nodiscard]] const JumpReach& reach() const { return reach_; }
    [[nodiscard]] ObjectId player() const { return asked_.player; }

private:
    /// The state for which the jump reach was computed.
    struct Asked {
        ObjectId player;
        bool playing = false;
        std::uint64_t revision = 0;  ///< revision of the scene
        std::int64_t tick = 0;       ///< tick of the running game
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    [[nodiscard]] static ObjectId playerOf(const Workspace& workspace, bool any);
    [[nodiscard]] bool outdated(const Workspace& workspace, const Asked& now) const;

    GhostGame ghost_;
    JumpReach reach_;
    Asked asked_;
    Vec2 from_;  // px, world: position of the player when the computation began
};

}  // namespace plumb::editor
