#include "physics/broadphase/tree.hpp"

#include <bit>
#include <numeric>

#include "physics/broadphase/tree_search.hpp"

namespace plumb::physics {

namespace {

constexpr std::uint32_t kLaneBits = 30;
constexpr std::uint32_t kNoLane = 0xffffffffu;

constexpr std::uint32_t treeOfLane(std::uint32_t lane) { return lane >> kLaneBits; }
constexpr std::uint32_t laneInTree(std::uint32_t lane) { return lane & ((1u << kLaneBits) - 1); }

}  // namespace

std::uint32_t TreeBroadPhase::treeOf(ProxyMotion motion) {
    constexpr std::uint32_t kTree[] = {kTrees, kStatic, kAsleep, kMoving, kMoving};
    return kTree[static_cast<std::size_t>(motion)];
}

void TreeBroadPhase::rebuild(const Proxies& proxies) {
    for (PackedTree& tree : trees_) tree.clear();
    lanes_.assign(proxies.bounds.size(), kNoLane);
    std::vector<std::uint32_t> all(proxies.bounds.size());
    std::iota(all.begin(), all.end(), 0u);
    update(proxies, all);
}

/// Takes those out of their trees that belong to another now, and collects who arrives.
void TreeBroadPhase::sendToTrees(const Proxies& proxies, std::span<const std::uint32_t> changed) {
    for (auto& arrivals : arrivals_) arrivals.clear();
    for (const std::uint32_t id : changed) {
        const std::uint32_t wanted = treeOf(proxies.motions[id]);
        const std::uint32_t lane = lanes_[id];
        if (lane != kNoLane) {
            if (treeOfLane(lane) == wanted) continue;
            trees_[treeOfLane(lane)].erase(laneInTree(lane));
            lanes_[id] = kNoLane;
        }
        if (wanted < kTrees) arrivals_[wanted].push_back(id);
    }
}

void TreeBroadPhase::update(const Proxies& proxies, std::span<const std::uint32_t> changed) {
    if (changed.empty()) return;
    lanes_.resize(proxies.bounds.size(), kNoLane);
    sendToTrees(proxies, changed);
    std::array<bool, kTrees> sorted{};
    for (std::uint32_t i = 0; i < kTrees; ++i)
        sorted[i] = trees_[i].take(proxies, arrivals_[i], lanes_, i << kLaneBits);
    for (const std::uint32_t id : changed) {
        const std::uint32_t lane = lanes_[id];
        if (lane != kNoLane && !sorted[treeOfLane(lane)])
            trees_[treeOfLane(lane)].read(proxies, laneInTree(lane));
    }
    for (std::uint32_t i = 0; i < kTrees; ++i) {
        trees_[i].refit(changed.size());
        if (!trees_[i].isDue()) continue;
        trees_[i].take(proxies, {}, lanes_, i << kLaneBits);
        trees_[i].refit(0);
    }
}

void TreeBroadPhase::arrange(std::span<std::uint32_t> moved) {
    for (std::uint32_t i = 0; i < kTrees; ++i) marks_[i].resize(trees_[i].lanes() / 64 + 1);
    std::size_t count = 0;
    for (const std::uint32_t id : moved) {
        const std::uint32_t lane = id < lanes_.size() ? lanes_[id] : kNoLane;
        if (lane == kNoLane) {
            moved[count++] = id;  // nobody's neighbour
            continue;
        }
        marks_[treeOfLane(lane)][laneInTree(lane) / 64] |= std::uint64_t{1} << lane % 64;
    }
    for (std::uint32_t i = 0; i < kTrees; ++i) {
        for (std::size_t word = 0; word < marks_[i].size(); ++word) {
            for (std::uint64_t bits = marks_[i][word]; bits != 0; bits &= bits - 1) {
                const std::size_t lane = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
                moved[count++] = trees_[i].leaves()[lane / kBranch].ids[lane % kBranch];
            }
            marks_[i][word] = 0;
        }
    }
}

void TreeBroadPhase::findPairs(const Proxies&, std::span<const std::uint32_t> moved,
                               std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const {
    PairSearch search;
    search.isMoved = isMoved.data();
    for (std::size_t i = 0; i < moved.size();) {
        const std::uint32_t lane = lanes_[moved[i]];
        std::uint32_t lanes = 0;
        for (; i < moved.size() && lanes_[moved[i]] / kBranch == lane / kBranch; ++i)
            lanes |= 1u << lanes_[moved[i]] % kBranch;
        if (lane == kNoLane) continue;
        const std::uint32_t own = treeOfLane(lane);
        search.own = &trees_[own];
        search.ownMayBeAwake = own == kMoving;
        search.leaf = laneInTree(lane) / kBranch;
        for (std::uint32_t other = own == kMoving ? 0u : kMoving; other < kTrees; ++other) {
            // Of two that both rest none is awake, so only who is awake looks among them.
            search.lanes = other == kMoving ? lanes : lanes & search.own->leaves()[search.leaf].awake;
            search.others = &trees_[other];
            if (search.lanes != 0 && !search.others->empty()) search_.findPairs(search, pairs);
        }
    }
}

void TreeBroadPhase::query(const Proxies&, const AABB& box, std::uint32_t mask,
                           std::vector<std::uint32_t>& found) const {
    for (const PackedTree& tree : trees_) {
        if (!tree.empty()) search_.findInBox(tree, usable(box), mask, found);
    }
}

void TreeBroadPhase::cast(const Proxies&, Vec2 from, Vec2 way, Vec2 half, std::uint32_t mask,
                          std::vector<std::uint32_t>& found) const {
    const LineSweep sweep = lineSweep(from, way, half);
    for (const PackedTree& tree : trees_) {
        if (!tree.empty()) search_.findOnSweep(tree, sweep, mask, found);
    }
}

}  // namespace plumb::physics
