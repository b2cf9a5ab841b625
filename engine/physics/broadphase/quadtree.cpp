#include "physics/broadphase/quadtree.hpp"

namespace plumb::physics {

void QuadtreeBroadPhase::findPairs(std::span<const std::uint32_t> moved,
                                   std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const {
    for (const std::uint32_t id : moved) {
        const ProxyPlace place = placeOf(id);
        if (place == kNoPlace) continue;
        const std::uint32_t own = partOfPlace(place);
        const LooseQuadtree::Item& looker = parts_[own].itemAt(inPart(place));
        if (looker.box == kNowhere) continue;
        for (std::uint32_t other = own == kMovingPart ? 0u : kMovingPart; other < kParts; ++other) {
            const LooseQuadtree& tree = parts_[other];
            // Only awake proxies pair with static ones.
            if (other == kStaticPart && !looker.awake) continue;
            if (tree.size() == 0 || !tree.all().mayCollide(looker.filter)) continue;
            tree.visitNear(looker.box, nullptr, [&](std::uint32_t partner) {
                const LooseQuadtree::Item& item = tree.itemAt(partner);
                // Of two moved proxies, only one reports the pair: within a partition the one with the lower
                // id, otherwise the one in the moving partition.
                const bool theirs = own == other ? item.id <= id : own != kMovingPart;
                if ((theirs && isMoved[item.id] != 0) || item.id == id) return;
                if (!looker.awake && !item.awake && !allCanPair(own, other)) return;
                if (meet(looker.filter, item.filter)) pairs.push_back(pairKey(id, item.id));
            });
        }
    }
}

}  // namespace plumb::physics
