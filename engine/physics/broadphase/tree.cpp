#include "physics/broadphase/tree.hpp"

#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

void TreeBroadPhase::findPairs(const Proxies&, std::span<const std::uint32_t> moved,
                               std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const {
    TreeSearch search;
    search.isMoved = isMoved.data();
    for (std::size_t i = 0; i < moved.size();) {
        // Proxies of one leaf are searched for together.
        const ProxyPlace place = proxies_.placeOf(moved[i]);
        std::uint32_t lanes = 0;
        for (; i < moved.size(); ++i) {
            const ProxyPlace next = proxies_.placeOf(moved[i]);
            if (next / kBranch != place / kBranch) break;
            lanes |= 1u << next % kBranch;
        }
        if (place == kNoPlace) continue;
        const std::uint32_t part = partOfPlace(place);
        search.own = &proxies_.parts[part];
        search.ownMayBeAwake = part == kMovingPart;
        search.leaf = inPart(place) / kBranch;
        for (std::uint32_t other = part == kMovingPart ? 0u : kMovingPart; other < kParts; ++other) {
            // Only awake proxies pair with static ones.
            search.lanes = other == kStaticPart ? lanes & search.own->leaves()[search.leaf].awake : lanes;
            search.allCanPair = allCanPair(part, other);
            search.others = &proxies_.parts[other];
            if (search.lanes != 0 && search.others->size() > 0) searches_.trees.findPairs(search, pairs);
        }
    }
}

void TreeBroadPhase::query(const Proxies&, const AABB& box, std::uint32_t mask,
                           std::vector<std::uint32_t>& found) const {
    for (const Bvh8& tree : proxies_.parts) {
        if (tree.size() > 0) searches_.trees.findInBox(tree, usable(box), mask, found);
    }
}

void TreeBroadPhase::cast(const Proxies&, Vec2 from, Vec2 displacement, Vec2 half, std::uint32_t mask,
                          std::vector<std::uint32_t>& found, Among among) const {
    const LineSweep sweep = lineSweep(from, displacement, half);
    for (const Bvh8& tree : proxies_.partsAmong(among)) {
        if (tree.size() > 0) searches_.trees.findOnSweep(tree, sweep, mask, found);
    }
}

}  // namespace plumb::physics
