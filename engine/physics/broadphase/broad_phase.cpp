#include "physics/broadphase/broad_phase.hpp"

#include "physics/broadphase/hierarchical_grid.hpp"
#include "physics/broadphase/loose_quadtree.hpp"
#include "physics/broadphase/sweep_and_prune_axis.hpp"

// The broad phases, and how each finds the pairs of what moved.

namespace plumb::physics {

namespace {

/// Trees of bounding boxes with eight children per node. The default: no distribution of sizes and positions
/// degrades it.
class TreeBroadPhase final : public PartitionedBroadPhase<Bvh8> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override {
        TreeSearch search;
        search.isMoved = isMoved.data();
        for (std::size_t i = 0; i < moved.size();) {
            // Proxies of one leaf are searched for together.
            const ProxyPlace place = placeOf(moved[i]);
            std::uint32_t lanes = 0;
            for (; i < moved.size(); ++i) {
                const ProxyPlace next = placeOf(moved[i]);
                if (next / kBranch != place / kBranch) break;
                lanes |= 1u << next % kBranch;
            }
            if (place == kNoPlace) continue;
            const std::uint32_t part = partOfPlace(place);
            search.own = &parts_[part];
            search.ownMayBeAwake = part == kMovingPart;
            search.leaf = inPart(place) / kBranch;
            for (std::uint32_t other = firstPartner(part); other < kParts; ++other) {
                // Only awake proxies pair with static ones.
                search.lanes = other == kStaticPart ? lanes & search.own->leaves()[search.leaf].awake : lanes;
                search.allCanPair = allCanPair(part, other);
                search.others = &parts_[other];
                if (search.lanes != 0 && search.others->size() > 0) searches_.findPairsOfLeaf(search, pairs);
            }
        }
    }
};

/// Loose quadtrees. A step never sorts all proxies again (unless most are new): the best choice where many
/// proxies come and go and no single step may be slow.
class QuadtreeBroadPhase final : public PartitionedBroadPhase<LooseQuadtree> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override {
        for (const std::uint32_t id : moved) {
            const ProxyPlace place = placeOf(id);
            if (place == kNoPlace) continue;
            const std::uint32_t own = partOfPlace(place);
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
                    if (meet(looker.filter, item.filter)) pairs.push_back(pairKey(id, item.id));
                });
            }
        }
    }
};

/// Boxes in rows, such that boxes near each other lie in few ranges of slots, which are compared eight at a
/// time. In addition to what PartitionedBroadPhase needs, a Part is a SortedRows and has
///
///   bool areNear(a, b)     true if the proxies in slots a < b should be searched for together
template <class Part>
class RowBroadPhase final : public PartitionedBroadPhase<Part> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override {
        for (std::uint32_t own = 0; own < kParts; ++own) {
            for (std::uint32_t other = firstPartner(own); other < kParts; ++other) {
                RowSearch search;
                search.own = &parts_[own];
                search.others = &parts_[other];
                search.ownMayBeAwake = own == kMovingPart;
                search.allCanPair = allCanPair(own, other);
                search.onlyLater = own == other && this->areAllArranged(own);
                search.isMoved = isMoved.data();
                if (search.own->size() > 0 && search.others->size() > 0)
                    findPairsAmong(search, own, other, moved, pairs);
            }
        }
    }

private:
    using PartitionedBroadPhase<Part>::parts_;

    /// False if a moved proxy cannot have partners in `others`.
    static bool looks(const RowSearch& search, std::uint32_t place) {
        const bool amongStatic = search.ownMayBeAwake && search.own != search.others && !search.allCanPair;
        if (amongStatic && search.own->states[place] != BoxRows::kAwake) return false;
        return search.others->all.mayCollide(search.own->filters[place]) &&
               search.own->boxAt(place) != kNowhere;
    }

    static bool mayJoin(const RowSearch& search, const Part& own, std::uint32_t looker) {
        return search.count < RowSearch::kMaxLookers && search.lookers[search.count - 1] < looker &&
               own.areNear(search.lookers[0], looker);
    }

    void findPairsAmong(RowSearch& search, std::uint32_t part, std::uint32_t other,
                        std::span<const std::uint32_t> moved, std::vector<PairKey>& pairs) const {
        const Part& own = parts_[part];
        const Part& others = parts_[other];
        AABB box = kNowhere;
        for (const std::uint32_t id : moved) {
            const ProxyPlace place = this->placeOf(id);
            if (place == kNoPlace || partOfPlace(place) != part || !looks(search, inPart(place))) continue;
            const std::uint32_t looker = inPart(place);
            if (search.count > 0 && !mayJoin(search, own, looker)) {
                findPairsNear(search, others, box, pairs);
                search.count = 0;
                box = kNowhere;
            }
            search.lookers[search.count++] = looker;
            box = merged(box, search.own->boxAt(looker));
        }
        if (search.count > 0) findPairsNear(search, others, box, pairs);
    }

    void findPairsNear(const RowSearch& search, const Part& others, const AABB& box,
                       std::vector<PairKey>& pairs) const {
        std::array<Stretch, 32> stretches;
        std::size_t count = 0;
        others.visitNear(box, nullptr, search.onlyLater ? search.lookers[0] + 1 : 0,
                         [&](std::uint32_t begin, std::uint32_t end) {
                             if (begin >= end) return;
                             if (count == stretches.size()) {
                                 this->searches_.findPairsInRows(search, stretches, pairs);
                                 count = 0;
                             }
                             stretches[count++] = {begin, end};
                         });
        this->searches_.findPairsInRows(search, {stretches.data(), count}, pairs);
    }
};

struct Kind {
    std::string_view name;
    std::unique_ptr<BroadPhase> (*make)();
};

template <class Phase>
std::unique_ptr<BroadPhase> make() {
    return std::make_unique<Phase>();
}

constexpr std::array<Kind, static_cast<std::size_t>(BroadPhaseKind::Count)> kKinds{{
    {"tree", &make<TreeBroadPhase>},
    {"grid", &make<RowBroadPhase<HierarchicalGrid>>},
    {"sweep and prune", &make<RowBroadPhase<SweepAndPruneAxis>>},
    {"quadtree", &make<QuadtreeBroadPhase>},
}};

const Kind& entryOf(BroadPhaseKind kind) {
    const auto i = static_cast<std::size_t>(kind);
    return kKinds[i < kKinds.size() ? i : 0];
}

}  // namespace

std::unique_ptr<BroadPhase> makeBroadPhase(BroadPhaseKind kind) { return entryOf(kind).make(); }

std::string_view nameOf(BroadPhaseKind kind) { return entryOf(kind).name; }

}  // namespace plumb::physics
