#include "physics/broadphase/tree.hpp"

namespace plumb::physics {

void TreeBroadPhase::findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                               std::vector<PairKey>& pairs) const {
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
        for (std::uint32_t other = part == kMovingPart ? 0u : kMovingPart; other < kParts; ++other) {
            // Only awake proxies pair with static ones.
            search.lanes = other == kStaticPart ? lanes & search.own->leaves()[search.leaf].awake : lanes;
            search.allCanPair = allCanPair(part, other);
            search.others = &parts_[other];
            if (search.lanes != 0 && search.others->size() > 0) searches_.findPairsOfLeaf(search, pairs);
        }
    }
}

}  // namespace plumb::physics
