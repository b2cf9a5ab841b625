#pragma once

#include <algorithm>
#include <array>

#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

/// A broad phase that stores boxes in rows, such that boxes near each other lie in few ranges of slots, which
/// are compared eight at a time. In addition to what PartitionedBroadPhase needs, a Part is a BoxRows and has
///
///   bool areNear(a, b)     true if the proxies in slots a < b should be searched for together
///   void visitNear(box, sweep, from, visit)  calls visit(begin, end) with ranges, none before `from`, that
///                          contain all boxes that may overlap `box`, each slot once; if `sweep` is not null,
///                          those that it may hit suffice
template <class Part>
class RowBroadPhase final : public PartitionedBroadPhase<Part> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override {
        for (std::uint32_t own = 0; own < kParts; ++own) {
            // Resting proxies pair with moving ones only.
            for (std::uint32_t other = own == kMovingPart ? 0u : kMovingPart; other < kParts; ++other) {
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

}  // namespace plumb::physics
