#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/box_searches.hpp"
#include "physics/broadphase/overlap.hpp"
#include "physics/broadphase/proxy_partitions.hpp"

namespace plumb::physics {

/// A broad phase that stores boxes in rows, such that boxes near each other lie in few ranges of slots, which
/// are compared eight at a time. In addition to what ProxyPartitions needs, a Part has
///
///   const BoxRows& rows()
///   bool areNear(a, b)                true if the proxies in slots a < b should be searched for together
///   void visitNear(box, from, visit)  calls visit(begin, end) with ranges, none before `from`, that contain
///                                     all boxes that may overlap `box`, each slot once
///   void visitAlong(sweep, visit)     the same for a sweep
template <class Part>
class RowBroadPhase final : public BroadPhase {
public:
    explicit RowBroadPhase(const BoxSearches& searches) : searches_{searches} {}

    void rebuild(const Proxies& proxies) override { proxies_.rebuild(proxies); }
    void update(const Proxies& proxies, std::span<const std::uint32_t> changed) override {
        proxies_.update(proxies, changed);
    }
    void arrange(std::span<std::uint32_t> moved) override { proxies_.arrange(moved); }

    void findPairs(const Proxies&, std::span<const std::uint32_t> moved,
                   std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const override {
        for (std::uint32_t own = 0; own < kParts; ++own) {
            // Resting proxies pair with moving ones only.
            for (std::uint32_t other = own == kMovingPart ? 0u : kMovingPart; other < kParts; ++other) {
                RowSearch search;
                search.own = &proxies_.parts[own].rows();
                search.others = &proxies_.parts[other].rows();
                search.ownMayBeAwake = own == kMovingPart;
                search.allCanPair = allCanPair(own, other);
                search.onlyLater = own == other && proxies_.areAllArranged(own);
                search.isMoved = isMoved.data();
                if (search.own->size() > 0 && search.others->size() > 0)
                    findPairsAmong(search, proxies_.parts[own], proxies_.parts[other], moved, pairs);
            }
        }
    }

    void query(const Proxies&, const AABB& box, std::uint32_t mask,
               std::vector<std::uint32_t>& found) const override {
        const AABB asked = usable(box);
        if (asked == kNowhere) return;
        for (const Part& part : proxies_.parts) {
            if (part.size() == 0) continue;
            part.visitNear(asked, 0, [&](std::uint32_t begin, std::uint32_t end) {
                searches_.rows.findInBox(part.rows(), {begin, end}, asked, nullptr, mask, found);
            });
        }
    }

    void cast(const Proxies&, Vec2 from, Vec2 displacement, Vec2 half, std::uint32_t mask,
              std::vector<std::uint32_t>& found, Among among) const override {
        const LineSweep sweep = lineSweep(from, displacement, half);
        if (sweep.bounds == kNowhere) return;
        for (const Part& part : proxies_.partsAmong(among)) {
            if (part.size() == 0) continue;
            part.visitAlong(sweep, [&](std::uint32_t begin, std::uint32_t end) {
                searches_.rows.findInBox(part.rows(), {begin, end}, sweep.bounds, &sweep, mask, found);
            });
        }
    }

    void visitRegions(RegionVisitor& visitor) const { proxies_.visitRegions(visitor); }

private:
    /// False if a moved proxy cannot have partners in `others`.
    static bool looks(const RowSearch& search, std::uint32_t place) {
        const bool amongStatic = search.ownMayBeAwake && search.own != search.others && !search.allCanPair;
        if (amongStatic && search.own->states[place] != BoxRows::kAwake) return false;
        return search.others->mayCollide(search.own->filters[place]) && search.own->boxAt(place) != kNowhere;
    }

    static bool mayJoin(const RowSearch& search, const Part& own, std::uint32_t looker) {
        return search.count < RowSearch::kMaxLookers && search.lookers[search.count - 1] < looker &&
               own.areNear(search.lookers[0], looker);
    }

    void findPairsAmong(RowSearch& search, const Part& own, const Part& others,
                        std::span<const std::uint32_t> moved, std::vector<PairKey>& pairs) const {
        const auto part = static_cast<std::uint32_t>(&own - proxies_.parts.data());
        AABB box = kNowhere;
        for (const std::uint32_t id : moved) {
            const ProxyPlace place = proxies_.placeOf(id);
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
        others.visitNear(box, search.onlyLater ? search.lookers[0] + 1 : 0,
                         [&](std::uint32_t begin, std::uint32_t end) {
                             if (begin >= end) return;
                             if (count == stretches.size()) {
                                 searches_.rows.findPairs(search, stretches, pairs);
                                 count = 0;
                             }
                             stretches[count++] = {begin, end};
                         });
        searches_.rows.findPairs(search, {stretches.data(), count}, pairs);
    }

    const BoxSearches& searches_;
    ProxyPartitions<Part> proxies_;
};

}  // namespace plumb::physics
