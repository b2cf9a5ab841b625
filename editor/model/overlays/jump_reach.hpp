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

/// Where a player character can get to from where it stands. Nothing is estimated: copies of the game are
/// played, in which it runs and jumps in all the ways of a fixed list; from where it lands it goes on, a few
/// times. Done in pieces, so that the editor stays quick.
class JumpReach {
public:
    static constexpr int kHops = 8;             ///< landings after one another
    static constexpr std::size_t kPlaces = 64;  ///< landings that are gone on from

    /// One way through the air.
    struct Arc {
        std::vector<Vec2> points;  ///< px: of the middle of its feet
        int hops = 1;              ///< jumps from where it stands, with this one
        bool lands = false;
    };
    /// A place to stand on.
    struct Landing {
        AABB box;  ///< px: of the character
        int hops = 0;
    };

    /// Begins anew.
    /// @param game    the world is as it is at the start; this plays in it from then on
    /// @param player  of that world
    void begin(PlaySession& game, EntityId player);
    void clear();
    /// Goes on. @param seconds  of CPU that may be used. @return how many ticks were played
    int work(double seconds);

    [[nodiscard]] bool done() const { return places_.empty(); }
    [[nodiscard]] const std::vector<Arc>& arcs() const { return arcs_; }
    [[nodiscard]] const std::vector<Landing>& landings() const { return landings_; }
    /// Whether it can be in a place: its box covers that, on one of the ways.
    [[nodiscard]] bool reaches(Vec2 place) const;
    static constexpr float kCell = 8.0f;  ///< px: side of the squares that are reached or not
    struct Cell {
        int x = 0;
        int y = 0;
        friend constexpr auto operator<=>(const Cell&, const Cell&) = default;
    };
    /// With the fewest jumps that it takes.
    [[nodiscard]] const std::map<Cell, int>& cells() const { return cells_; }

private:
    struct Plan;
    /// Where it stands, and the game then.
    struct Place {
        Snapshot world;
        int hops = 0;
        std::size_t next = 0;  ///< plan
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
    Key left_ = Key::Left;
    Key right_ = Key::Right;
    Key jump_ = Key::Space;
    std::deque<Place> places_;  // still to go on from
    std::size_t placed_ = 0;
    std::set<Cell> stood_;  // cells that it landed on already
    std::map<Cell, int> cells_;
    std::vector<Arc> arcs_;
    std::vector<Landing> landings_;
};

}  // namespace plumb::editor
