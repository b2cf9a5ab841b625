#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/hilbert_order.hpp"
#include "physics/broadphase/overlap.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

struct BoxSearches;
struct PlaceList;

/// A loose quadtree: nested squares, each level half as wide as the one above. A square with many boxes
/// passes those that are small enough on to its quarters. A box belongs to a square that contains its centre
/// and is no smaller than the box, so the box may extend beyond it by half the width of the square. Therefore
/// inserting, removing and moving a box cost the same in any world, and next to nothing while the centre
/// stays in its square.
/// Source: T. Ulrich, "Loose Octrees", Game Programming Gems, 2000
class LooseQuadtree {
public:
    struct Item {
        AABB box;
        Filter filter;
        std::uint32_t id = 0;
        std::uint32_t node = kNone;  ///< kNone: the item is free
        std::uint32_t next = kNone;  ///< next item of the same node
        std::uint32_t previous = kNone;
        bool awake = false;
    };

    // Interface for PartitionedBroadPhase.
    /// Along a curve, so that neighbours in space are inserted one after the other and lie close together in
    /// memory.
    void sort(const Proxies& proxies, std::span<std::uint32_t> ids, std::uint32_t moving,
              const PlaceList& list);
    void add(const Proxies& proxies, std::span<const std::uint32_t> ids, const PlaceList& list);
    void erase(std::uint32_t place);
    std::uint32_t move(const Proxies& proxies, std::uint32_t place);
    void settle(std::size_t) {}
    [[nodiscard]] bool isDue(std::size_t arrivals, std::uint32_t moving) const;
    [[nodiscard]] std::uint32_t places() const { return static_cast<std::uint32_t>(items_.size()); }
    [[nodiscard]] std::uint32_t size() const { return places() - static_cast<std::uint32_t>(free_.size()); }
    [[nodiscard]] bool isFree(std::uint32_t place) const { return items_[place].node == kNone; }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t place) const { return items_[place].id; }
    void find(const BoxSearches& searches, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
              std::vector<std::uint32_t>& found) const;
    void visitRegions(const std::function<void(const AABB&)>& visit) const;

    [[nodiscard]] const Item& itemAt(std::uint32_t place) const { return items_[place]; }
    /// Of all proxies that were stored since sort().
    [[nodiscard]] const FilterUnion& all() const { return all_; }
    /// Calls visit(place) for each box that overlaps `box`. With a sweep, skips squares that it misses.
    template <class Visit>
    void visitNear(const AABB& box, const LineSweep* sweep, const Visit& visit) const;

private:
    static constexpr std::uint32_t kOutside = 0;  ///< node of boxes too far away or too large for squares
    static constexpr int kMaxLevels = 64;

    struct Node {
        AABB reach = kNowhere;  ///< union of all boxes that were in it or below since it was last empty
        Vec2 middle;            ///< m
        float half = 0.0f;      ///< m
        std::uint32_t parent = kNone;
        std::uint32_t children =
            kNone;  ///< the first of four; a node with children keeps only the boxes that these cannot hold
        std::uint32_t firstItem = kNone;
        std::uint32_t count = 0;  ///< number of items in it and below
    };

    /// The square that a box needs.
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
    void read(const Proxies& proxies, std::uint32_t place, std::uint32_t id);

    std::vector<Node> nodes_;  ///< node 0 is kOutside
    std::vector<Item> items_;
    std::vector<std::uint32_t> free_;
    std::uint32_t root_ = kNone;
    FilterUnion all_;
    HilbertOrder curve_;
};

template <class Visit>
void LooseQuadtree::visitNear(const AABB& box, const LineSweep* sweep, const Visit& visit) const {
    std::array<std::uint32_t, 3 * kMaxLevels + 2> stack;
    std::size_t depth = 0;
    stack[depth++] = kOutside;
    if (root_ != kNone) stack[depth++] = root_;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        for (std::uint32_t place = node.firstItem; place != kNone; place = items_[place].next) {
            if (touch(items_[place].box, box)) visit(place);
        }
        if (node.children == kNone) continue;
        for (std::uint32_t child = node.children; child < node.children + 4; ++child) {
            const AABB& reach = nodes_[child].reach;
            if (!touch(reach, box)) continue;
            if (sweep == nullptr || mayCollide(*sweep, reach)) stack[depth++] = child;
        }
    }
}

}  // namespace plumb::physics
