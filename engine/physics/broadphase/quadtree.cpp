#include "physics/broadphase/quadtree.hpp"

#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

void QuadtreeBroadPhase::findPairs(const Proxies&, std::span<const std::uint32_t> moved,
                                   std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const {
    for (const std::uint32_t id : moved) {
        const ProxyPlace place = proxies_.placeOf(id);
        if (place == kNoPlace) continue;
        const std::uint32_t own = partOfPlace(place);
        const LooseQuadtree::Item& looker = proxies_.parts[own].itemAt(inPart(place));
        if (looker.box == kNowhere) continue;
        for (std::uint32_t other = own == kMovingPart ? 0u : kMovingPart; other < kParts; ++other) {
            const LooseQuadtree& tree = proxies_.parts[other];
            // Only awake proxies pair with static ones.
            if (other == kStaticPart && !looker.awake) continue;
            if (tree.size() == 0 || !tree.mayCollide(looker.filter)) continue;
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

void QuadtreeBroadPhase::query(const Proxies&, const AABB& box, std::uint32_t mask,
                               std::vector<std::uint32_t>& found) const {
    for (const LooseQuadtree& tree : proxies_.parts) {
        tree.visitNear(usable(box), nullptr, [&](std::uint32_t place) {
            if ((tree.itemAt(place).filter.layers & mask) != 0) found.push_back(tree.itemAt(place).id);
        });
    }
}

void QuadtreeBroadPhase::cast(const Proxies&, Vec2 from, Vec2 displacement, Vec2 half, std::uint32_t mask,
                              std::vector<std::uint32_t>& found, Among among) const {
    const LineSweep sweep = lineSweep(from, displacement, half);
    for (const LooseQuadtree& tree : proxies_.partsAmong(among)) {
        tree.visitNear(sweep.bounds, &sweep, [&](std::uint32_t place) {
            const LooseQuadtree::Item& item = tree.itemAt(place);
            if ((item.filter.layers & mask) != 0 && mayCollide(sweep, item.box)) found.push_back(item.id);
        });
    }
}

}  // namespace plumb::physics
