#pragma once

#include "editor/model/overlays/ghost_game.hpp"
#include "editor/model/overlays/jump_reach.hpp"

namespace plumb::editor {

/// The jump reach of the selected player, kept up to date: found out anew when the scene was changed or the
/// player stands elsewhere, a little in each frame.
class ReachView {
public:
    static constexpr double kBudget = 0.004;  ///< s of CPU in a frame

    /// To be called in every frame in which it is shown.
    /// @param anyPlayer  also one that is not selected
    void tend(Workspace& workspace, bool anyPlayer);
    void clear();

    [[nodiscard]] const JumpReach& reach() const { return reach_; }
    [[nodiscard]] ObjectId player() const { return asked_.player; }

private:
    /// What it was found out for.
    struct Asked {
        ObjectId player;
        bool playing = false;
        std::uint64_t revision = 0;  ///< of the document
        std::int64_t tick = 0;       ///< of the game
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    [[nodiscard]] static ObjectId playerOf(const Workspace& workspace, bool any);
    [[nodiscard]] bool outdated(const Workspace& workspace, const Asked& now) const;

    GhostGame ghost_;
    JumpReach reach_;
    Asked asked_;
    Vec2 from_;  // px: where the player stood
};

}  // namespace plumb::editor
