#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/broadphase/curve_order.hpp"
#include "physics/broadphase/line_sweep.hpp"
#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

class RegionVisitor;

/// Squares in squares, half as wide from level to level; one with many boxes sends those that are small
/// enough on to its quarters. A box is in a square that its middle is in and that is no smaller than the box,
/// so it may stick out by half a square: coming, going and moving on cost the same in any world, and hardly
/// anything while the middle stays in the square. Source: T. Ulrich, "Loose Octrees", Game Programming Gems,
/// 2000
class LooseQuadtree {
public:
    struct Item {
        AABB box;
        Filter filter;
        std::uint32_t id = 0;
        std::uint32_t node = kNobody;  ///< kNobody: this item is free
        std::uint32_t next = kNobody;  ///< in the same node
        std::uint32_t previous = kNobody;
        bool awake = false;
    };

    // What PartedProxies asks of a part.
    bool take(const Proxies& proxies, std::span<std::uint32_t> arrivals, std::uint32_t moving,
              std::span<std::uint32_t> places, std::uint32_t first);
    void erase(std::uint32_t place);
    std::uint32_t move(const Proxies& proxies, std::uint32_t place);
    void settle(std::size_t) {}
    [[nodiscard]] bool isDue(std::size_t arrivals) const;
    [[nodiscard]] std::uint32_t places() const { return static_cast<std::uint32_t>(items_.size()); }
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t place) const { return items_[place].id; }
    void clear();
    void visitRegions(RegionVisitor& visitor) const;

    [[nodiscard]] const Item& itemAt(std::uint32_t place) const { return items_[place]; }
    /// Whether somebody here may meet one with this filter.
    [[nodiscard]] bool mayMeet(const Filter& filter) const;
    /// Calls visit(place) for all in squares that reach into the box and, unless that is null, that the sweep
    /// may meet.
    template <class Visit>
    void visitNear(const AABB& box, const LineSweep* sweep, const Visit& visit) const;

private:
    static constexpr std::uint32_t kNobody = 0xffffffffu;
    static constexpr std::uint32_t kOutside = 0;  ///< the node of those too far or too large for squares
    static constexpr int kMostLevels = 64;

    struct Node {
        AABB reach = kNowhere;  ///< of all who have been in it or below since it was empty
        Vec2 middle;            ///< m
        float half = 0.0f;      ///< m
        std::uint32_t parent = kNobody;
        std::uint32_t children =
            kNobody;  ///< the first of four; with them, it keeps only what they cannot hold
        std::uint32_t firstItem = kNobody;
        std::uint32_t count = 0;  ///< items in it and below
    };

    /// Where a box has to be.
    struct Goal {
        Vec2 middle;
        float half = 0.0f;  ///< m: half the width of the square
    };

    [[nodiscard]] static bool isOutside(const AABB& box);
    [[nodiscard]] static Goal goalOf(const AABB& box);
    [[nodiscard]] static bool holds(const Node& node, const Goal& goal);
    void growRoot(const Goal& goal);
    [[nodiscard]] std::uint32_t childFor(std::uint32_t node, const Goal& goal) const;
    void makeChildren(std::uint32_t node);
    void reachOut(std::uint32_t node, const AABB& box);
    void leave(std::uint32_t node);
    void split(std::uint32_t node);
    void link(std::uint32_t place, std::uint32_t node);
    void unlink(std::uint32_t place);
    void insert(std::uint32_t place, std::uint32_t from);
    void sortAll(const Proxies& proxies, std::span<const std::uint32_t> arrivals);
    void add(const Proxies& proxies, std::uint32_t id, std::span<std::uint32_t> places, std::uint32_t first);
    void read(const Proxies& proxies, std::uint32_t place, std::uint32_t id);

    std::vector<Node> nodes_;  ///< 0: outside
    std::vector<Item> items_;
    std::vector<std::uint32_t> free_;
    std::uint32_t root_ = kNobody;
    std::uint32_t size_ = 0;
    std::uint32_t layers_ = 0;  ///< of all that have been here
    std::uint32_t masks_ = 0;

    CurveOrder curve_;
    std::vector<std::uint32_t> order_;
};

template <class Visit>
void LooseQuadtree::visitNear(const AABB& box, const LineSweep* sweep, const Visit& visit) const {
    std::array<std::uint32_t, 3 * kMostLevels + 2> stack;
    std::size_t depth = 0;
    if (nodes_.empty()) return;
    stack[depth++] = kOutside;
    if (root_ != kNobody) stack[depth++] = root_;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        for (std::uint32_t place = node.firstItem; place != kNobody; place = items_[place].next) {
            if (touch(items_[place].box, box)) visit(place);
        }
        if (node.children == kNobody) continue;
        for (std::uint32_t child = node.children; child < node.children + 4; ++child) {
            const AABB& reach = nodes_[child].reach;
            if (!touch(reach, box)) continue;
            if (sweep == nullptr || physics::mayMeet(*sweep, reach)) stack[depth++] = child;
        }
    }
}

}  // namespace plumb::physics
