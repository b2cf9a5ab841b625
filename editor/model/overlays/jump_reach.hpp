#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "ecs/snapshot.hpp"
#include "editor/model/play/play_mode.hpp"
#include "math/rect.hpp"

namespace plumb::editor {

/// Computes the region that a player character can reach by running and jumping. The result is simulated, not
/// estimated: a copy of the game is played with each input sequence of a fixed list, then again from each
/// landing, up to `kHops` times. The work is spread over frames, so that the editor stays responsive.
class JumpReach {
public:
    static constexpr int kHops = 8;             ///< maximum number of consecutive jumps
    static constexpr std::size_t kPlaces = 64;  ///< maximum number of landings from which jumps are simulated

    /// The path of one jump or fall.
    struct Arc {
        std::vector<Vec2> points;  ///< px, world: bottom center of the character's box in each tick
        int hops = 1;              ///< number of jumps from the initial position, including this one
        bool lands = false;        ///< the character is on the ground at the end of the path
    };
    /// A position in which the character stands on the ground.
    struct Landing {
        AABB box;      ///< px, world: the character's box
        int hops = 0;  ///< number of jumps from the initial position
    };

    /// Discards all results and starts again.
    /// @param game    in its initial state; its world is changed by the simulation from then on
    /// @param player  entity in the world of `game`
    void begin(PlaySession& game, EntityId player);
    void clear();
    /// Continues the simulation. @param seconds  limit of CPU time. @return number of ticks simulated
    int work(double seconds);

    [[nodiscard]] bool done() const { return places_.empty(); }
    [[nodiscard]] const std::vector<Arc>& arcs() const { return arcs_; }
    [[nodiscard]] const std::vector<Landing>& landings() const { return landings_; }
    /// True if the character's box covers this point (px, world) in one of the simulated jumps.
    [[nodiscard]] bool reaches(Vec2 place) const;
    static constexpr float kCell = 8.0f;  ///< px: side length of the grid cells of `cells`
    struct Cell {
        int x = 0;
        int y = 0;
        friend constexpr auto operator<=>(const Cell&, const Cell&) = default;
    };
    /// The reached grid cells, each with the minimum number of jumps needed.
    [[nodiscard]] const std::map<Cell, int>& cells() const { return cells_; }

private:
    struct Plan;
    /// A landing from which jumps are simulated.
    struct Place {
        Snapshot world;        ///< state of the game at the landing
        int hops = 0;          ///< number of jumps from the initial position
        std::size_t next = 0;  ///< index of the next plan (input sequence) to simulate
    };
    static const std::vector<Plan>& plans(bool first);
    [[nodiscard]] InputFrame hands(const Plan& plan, int tick, int jumpedAt) const;
    int tryPlan(const Place& place, const Plan& plan);
    void cover(const AABB& box, int hops);
    void land(int hops);
    void settle();
    [[nodiscard]] bool alive() const;
    [[nodiscard]] bool grounded() const;
    [[nodiscard]] AABB box() const;

    PlaySession* game_ = nullptr;
    EntityId player_;
    Key left_ = Key::Left;  // key that the simulation presses to run left
    Key right_ = Key::Right;
    Key jump_ = Key::Space;
    std::deque<Place> places_;  // landings with plans left to simulate
    std::size_t placed_ = 0;    // number of landings queued so far, at most kPlaces
    std::set<Cell> stood_;      // grid cells with a landing
    std::map<Cell, int> cells_;
    std::vector<Arc> arcs_;
    std::vector<Landing> landings_;
};

}  // namespace plumb::editor
