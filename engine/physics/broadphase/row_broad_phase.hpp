#pragma once

#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

/// The common part of partitions that store their boxes in rows. The derived class, Rows, has
///
///   uint32 freePlace(box)  a free slot for a box
///   void visitNear(box, sweep, from, visit)  calls visit(begin, end) with ranges, none before `from`, that
///                          contain all boxes that may overlap `box`, each slot once; if `sweep` is not null,
///                          only boxes that it may hit are required
template <class Rows>
class SortedRows : public BoxRows {
public:
    using BoxRows::BoxRows;

    void add(const Proxies& proxies, std::span<const std::uint32_t> order, const LocationList& list) {
        for (const std::uint32_t id : order) {
            const AABB box = usable(proxies.bounds[id]);
            const std::uint32_t place = static_cast<Rows&>(*this).freePlace(box);
            write(proxies, place, id, box);
            list.set(id, place);
        }
    }
    void find(const BoxSearches& searches, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
              std::vector<std::uint32_t>& found) const {
        static_cast<const Rows&>(*this).visitNear(box, sweep, 0, [&](std::uint32_t begin, std::uint32_t end) {
            searches.findInRows(*this, {begin, end}, box, sweep, mask, found);
        });
    }
};

/// Stores boxes such that boxes near each other lie in few ranges of slots; searches test eight slots at a
/// time. In addition to what PartitionedBroadPhase needs, a Part is a SortedRows and has
///
///   bool areNear(a, b)     true if the proxies in slots a < b should search together
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

    void findPairsAmong(RowSearch& search, std::uint32_t part, std::uint32_t other,
                        std::span<const std::uint32_t> moved, std::vector<PairKey>& pairs) const {
        const Part& own = parts_[part];
        const Part& others = parts_[other];
        AABB box = kNowhere;
        for (const std::uint32_t id : moved) {
            const ProxyLocation place = this->placeOf(id);
            if (place == kNoLocation || partOfLocation(place) != part || !looks(search, inPart(place)))
                continue;
            const std::uint32_t looker = inPart(place);
            const bool joins = search.count > 0 && search.count < RowSearch::kMaxLookers &&
                               search.searchers[search.count - 1] < looker &&
                               own.areNear(search.searchers[0], looker);
            if (search.count > 0 && !joins) {
                findPairsNear(search, others, box, pairs);
                search.count = 0;
                box = kNowhere;
            }
            search.searchers[search.count++] = looker;
            box = merged(box, search.own->boxAt(looker));
        }
        if (search.count > 0) findPairsNear(search, others, box, pairs);
    }

    void findPairsNear(const RowSearch& search, const Part& others, const AABB& box,
                       std::vector<PairKey>& pairs) const {
        std::array<SlotRange, 32> ranges;
        std::size_t count = 0;
        others.visitNear(box, nullptr, search.onlyLater ? search.searchers[0] + 1 : 0,
                         [&](std::uint32_t begin, std::uint32_t end) {
                             if (begin >= end) return;
                             if (count == ranges.size()) {
                                 this->searches_.findPairsInRows(search, ranges, pairs);
                                 count = 0;
                             }
                             ranges[count++] = {begin, end};
                         });
        this->searches_.findPairsInRows(search, {ranges.data(), count}, pairs);
    }
};

}  // namespace plumb::physics
