#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "physics/broadphase/partitioned_broad_phase.hpp"
#include "physics/model/side_table.hpp"

namespace plumb::physics {

namespace {

constexpr float kFarthestSquare = 0x1p40f;   // m: no squares beyond this distance
constexpr float kSmallestSquare = 0x1p-12f;  // m: minimum half width of a square
constexpr std::uint32_t kMany = 8;           // a square with more boxes than this is split

/// The smallest power of two that is at least x.
float powerAbove(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(((bits + 0x7fffffu) >> 23) << 23);
}

/// A loose quadtree: nested squares, each level half as wide as the one above. A square with many boxes
/// passes those that are small enough on to its quarters. A box belongs to a square that contains its centre
/// and is no smaller than the box, so the box may extend beyond it by half the width of the square. Therefore
/// inserting, removing and moving a box cost the same in any world, and almost nothing while the centre
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
    /// Inserts the boxes along a Hilbert curve, so that neighbours in space are neighbours in memory.
    void sort(const Proxies& proxies, std::span<std::uint32_t> ids, std::uint32_t, const LocationList& list) {
        nodes_.assign(1, {});
        items_.clear();
        free_.clear();
        root_ = kNone;
        all_ = {};
        curve_.sort(proxies.bounds, ids);
        add(proxies, ids, list);
    }

    void add(const Proxies& proxies, std::span<const std::uint32_t> ids, const LocationList& list) {
        for (const std::uint32_t id : ids) {
            const std::uint32_t place = takeIndex(free_, items_);
            read(proxies, place, id);
            insert(place, kNone);
            list.set(id, place);
        }
    }

    void erase(std::uint32_t place) {
        unlink(place);
        for (std::uint32_t node = items_[place].node; node != kNone && node != kOutside;
             node = nodes_[node].parent)
            leave(node);
        items_[place].node = kNone;
        free_.push_back(place);
    }

    std::uint32_t move(const Proxies& proxies, std::uint32_t place) {
        read(proxies, place, items_[place].id);
        const Item& item = items_[place];
        const std::uint32_t old = item.node;
        const bool isFar = isOutside(item.box);
        const Goal goal = goalOf(item.box);
        const auto fits = [&](std::uint32_t node) { return !isFar && holds(nodes_[node], goal); };
        if (old != kOutside && fits(old) &&
            (nodes_[old].children == kNone || nodes_[old].half == goal.half)) {
            reachOut(old, item.box);
            return place;
        }
        // Goes up to the first square that holds the box, and down again from there.
        unlink(place);
        std::uint32_t node = old != kOutside ? old : kNone;
        while (node != kNone && !fits(node)) {
            leave(node);
            node = nodes_[node].parent;
        }
        insert(place, node);
        return place;
    }

    void settle(std::size_t) {}
    [[nodiscard]] bool isDue(std::size_t arrivals, std::uint32_t) const {
        // True if most boxes are new, or if moving boxes have left too many empty squares.
        return arrivals > size() || nodes_.size() > 2 * items_.size() + 4096;
    }
    [[nodiscard]] std::uint32_t places() const { return static_cast<std::uint32_t>(items_.size()); }
    [[nodiscard]] std::uint32_t size() const { return places() - static_cast<std::uint32_t>(free_.size()); }
    [[nodiscard]] bool isFree(std::uint32_t place) const { return items_[place].node == kNone; }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t place) const { return items_[place].id; }
    void find(const BoxSearches&, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
              std::vector<std::uint32_t>& found) const {
        visitNear(box, sweep, [&](std::uint32_t place) {
            const Item& item = items_[place];
            if ((item.filter.layers & mask) == 0) return;
            if (sweep == nullptr || mayCollide(*sweep, item.box)) found.push_back(item.id);
        });
    }

    void visitRegions(const std::function<void(const AABB&)>& visit) const {
        for (std::size_t i = kOutside + 1; i < nodes_.size(); ++i) {
            const Node& node = nodes_[i];
            const Vec2 half{node.half, node.half};
            if (node.count > 0) visit({node.middle - half, node.middle + half});
        }
    }

    [[nodiscard]] const Item& itemAt(std::uint32_t place) const { return items_[place]; }
    /// The filters of all proxies that were stored since sort().
    [[nodiscard]] const FilterUnion& all() const { return all_; }
    /// Calls visit(place) for each box that overlaps `box`. With a sweep, skips squares that it misses.
    template <class Visit>
    void visitNear(const AABB& box, const LineSweep* sweep, const Visit& visit) const {
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

private:
    static constexpr std::uint32_t kOutside = 0;  ///< node of boxes too far away or too large for squares
    static constexpr int kMaxLevels = 64;

    struct Node {
        AABB reach = kNowhere;  ///< union of all boxes that were in it or below since it was last empty
        Vec2 middle;            ///< m
        float half = 0.0f;      ///< m
        std::uint32_t parent = kNone;
        /// The first of four; a node with children keeps only the boxes that these cannot hold.
        std::uint32_t children = kNone;
        std::uint32_t firstItem = kNone;
        std::uint32_t count = 0;  ///< number of items in it and below
    };

    struct Goal {           ///< the square in which a box is stored
        Vec2 middle;        ///< m: centre of the box
        float half = 0.0f;  ///< m: half the width of the square
    };

    [[nodiscard]] static bool isOutside(const AABB& box) {
        const auto isNear = [](Vec2 point) {
            return std::fabs(point.x) < kFarthestSquare && std::fabs(point.y) < kFarthestSquare;
        };
        return !(isNear(box.min) && isNear(box.max));
    }
    [[nodiscard]] static Goal goalOf(const AABB& box) {
        const Vec2 size = box.size();
        return {middleOf(box), powerAbove(std::max({size.x * 0.5f, size.y * 0.5f, kSmallestSquare}))};
    }
    [[nodiscard]] static bool holds(const Node& node, const Goal& goal) {
        return node.half >= goal.half && std::fabs(goal.middle.x - node.middle.x) <= node.half &&
               std::fabs(goal.middle.y - node.middle.y) <= node.half;
    }
    void makeChildren(std::uint32_t node) {
        const Node parent = nodes_[node];
        const float half = parent.half * 0.5f;
        nodes_[node].children = static_cast<std::uint32_t>(nodes_.size());
        for (int i = 0; i < 4; ++i) {
            const Vec2 displacement{i % 2 == 0 ? -half : half, i / 2 == 0 ? -half : half};
            nodes_.push_back({kNowhere, parent.middle + displacement, half, node});
        }
    }

    /// Doubles the root until it holds the goal; each time, the former root becomes a quarter of the new one.
    void growRoot(const Goal& goal) {
        if (root_ == kNone) {
            root_ = static_cast<std::uint32_t>(nodes_.size());
            const float size = goal.half * 2.0f;
            const Vec2 corner{std::floor(goal.middle.x / size) * size,
                              std::floor(goal.middle.y / size) * size};
            nodes_.push_back({kNowhere, corner + Vec2{goal.half, goal.half}, goal.half});
        }
        while (!holds(nodes_[root_], goal)) {
            Node old = nodes_[root_];
            const Vec2 displacement{goal.middle.x < old.middle.x ? -old.half : old.half,
                                    goal.middle.y < old.middle.y ? -old.half : old.half};
            nodes_[root_] = {old.reach, old.middle + displacement, old.half * 2.0f};
            nodes_[root_].count = old.count;
            makeChildren(root_);
            const std::uint32_t quarter = nodes_[root_].children + ((displacement.x < 0.0f ? 1u : 0u) |
                                                                    (displacement.y < 0.0f ? 2u : 0u));
            old.parent = root_;
            nodes_[quarter] = old;
            for (std::uint32_t place = old.firstItem; place != kNone; place = items_[place].next)
                items_[place].node = quarter;
            for (std::uint32_t i = 0; i < 4 && old.children != kNone; ++i)
                nodes_[old.children + i].parent = quarter;
        }
    }

    [[nodiscard]] std::uint32_t childFor(std::uint32_t node, const Goal& goal) const {
        const Node& parent = nodes_[node];
        return parent.children +
               ((goal.middle.x >= parent.middle.x ? 1u : 0u) | (goal.middle.y >= parent.middle.y ? 2u : 0u));
    }
    /// Enlarges the bounds of a node and of those above it by a box.
    void reachOut(std::uint32_t node, const AABB& box) {
        for (; node != kNone && merged(nodes_[node].reach, box) != nodes_[node].reach;
             node = nodes_[node].parent)
            nodes_[node].reach = merged(nodes_[node].reach, box);
    }
    void leave(std::uint32_t node) {
        if (--nodes_[node].count == 0) nodes_[node].reach = kNowhere;
    }
    void link(std::uint32_t place, std::uint32_t node) {
        Item& item = items_[place];
        item.node = node;
        item.previous = kNone;
        item.next = nodes_[node].firstItem;
        if (item.next != kNone) items_[item.next].previous = place;
        nodes_[node].firstItem = place;
        if (node != kOutside) reachOut(node, item.box);
    }

    void unlink(std::uint32_t place) {
        const Item& item = items_[place];
        if (item.previous != kNone) {
            items_[item.previous].next = item.next;
        } else {
            nodes_[item.node].firstItem = item.next;
        }
        if (item.next != kNone) items_[item.next].previous = item.previous;
    }

    /// Creates the four quarters and moves down the items that they can hold.
    void split(std::uint32_t node) {
        makeChildren(node);
        std::uint32_t next = kNone;
        for (std::uint32_t place = nodes_[node].firstItem; place != kNone; place = next) {
            next = items_[place].next;
            const Goal goal = goalOf(items_[place].box);
            if (goal.half >= nodes_[node].half) continue;
            unlink(place);
            const std::uint32_t child = childFor(node, goal);
            ++nodes_[child].count;
            link(place, child);
        }
    }

    /// Inserts an item below the node `from`, which must hold it; kNone: below the root.
    void insert(std::uint32_t place, std::uint32_t from) {
        if (isOutside(items_[place].box)) return link(place, kOutside);
        const Goal goal = goalOf(items_[place].box);
        std::uint32_t node = from;
        if (node == kNone) {
            growRoot(goal);
            node = root_;
            ++nodes_[node].count;
        }
        while (nodes_[node].half > goal.half) {
            if (nodes_[node].children == kNone) {
                if (nodes_[node].count <= kMany) break;
                split(node);
            }
            node = childFor(node, goal);
            ++nodes_[node].count;
        }
        link(place, node);
    }

    void read(const Proxies& proxies, std::uint32_t place, std::uint32_t id) {
        Item& item = items_[place];
        item.box = usable(proxies.bounds[id]);
        item.filter = proxies.filters[id];
        item.id = id;
        item.awake = proxies.motions[id] == ProxyMotion::Awake;
        all_.add(item.filter);
    }

    std::vector<Node> nodes_;  ///< node 0 is kOutside
    std::vector<Item> items_;
    std::vector<std::uint32_t> free_;
    std::uint32_t root_ = kNone;
    FilterUnion all_;
    HilbertOrder curve_;
};

/// Loose quadtrees. A step never sorts all proxies again (unless most are new): the best choice where many
/// proxies are added and removed and no single step may be slow.
class QuadtreeBroadPhase final : public PartitionedBroadPhase<LooseQuadtree> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override {
        for (const std::uint32_t id : moved) {
            const ProxyLocation place = placeOf(id);
            if (place == kNoLocation) continue;
            const std::uint32_t own = partOfLocation(place);
            const LooseQuadtree::Item& looker = parts_[own].itemAt(inPart(place));
            if (looker.box == kNowhere) continue;
            for (std::uint32_t other = firstPartner(own); other < kParts; ++other) {
                const LooseQuadtree& tree = parts_[other];
                // Only awake proxies pair with static ones.
                if (other == kStaticPart && !looker.awake) continue;
                if (tree.size() == 0 || !tree.all().mayCollide(looker.filter)) continue;
                tree.visitNear(looker.box, nullptr, [&](std::uint32_t partner) {
                    const LooseQuadtree::Item& item = tree.itemAt(partner);
                    // Of two moved proxies, only one reports the pair: within a partition the one with the
                    // lower id, otherwise the one in the moving partition.
                    const bool theirs = own == other ? item.id <= id : own != kMovingPart;
                    if ((theirs && isMoved[item.id] != 0) || item.id == id) return;
                    if (!looker.awake && !item.awake && !allCanPair(own, other)) return;
                    if (mayCollide(looker.filter, item.filter)) pairs.push_back(pairKey(id, item.id));
                });
            }
        }
    }
};

}  // namespace

std::unique_ptr<BroadPhase> makeQuadtree() { return std::make_unique<QuadtreeBroadPhase>(); }

}  // namespace plumb::physics
