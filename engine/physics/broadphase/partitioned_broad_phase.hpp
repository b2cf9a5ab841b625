#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/box_searches.hpp"

namespace plumb::physics {

/// The three partitions of a broad phase, so that resting proxies cost a step nothing.
enum ProxyPart : std::uint32_t { kStaticPart, kAsleepPart, kMovingPart, kParts };

constexpr std::uint32_t partOf(ProxyMotion motion) {
    constexpr std::uint32_t kPart[] = {kParts, kStaticPart, kAsleepPart, kMovingPart, kMovingPart};
    return kPart[static_cast<std::size_t>(motion)];
}

/// True if all proxies of two partitions can pair (see findPairs()): one sleeps, so the other moves.
constexpr bool allCanPair(std::uint32_t own, std::uint32_t other) {
    return own == kAsleepPart || other == kAsleepPart;
}

/// The first partition with partners for proxies of `own`: resting proxies only pair with moving ones.
constexpr std::uint32_t firstPartner(std::uint32_t own) { return own == kMovingPart ? 0u : kMovingPart; }

/// The location of a proxy: its partition in the high 2 bits, its slot in that partition in the other bits.
using ProxyLocation = std::uint32_t;
inline constexpr ProxyLocation kNoLocation = 0xffffffffu;
inline constexpr std::uint32_t kPlaceBits = 30;
constexpr std::uint32_t partOfLocation(ProxyLocation place) { return place >> kPlaceBits; }
constexpr std::uint32_t inPart(ProxyLocation place) { return place & ((1u << kPlaceBits) - 1); }

inline void setBit(std::vector<std::uint64_t>& words, std::size_t i) {
    words[i / 64] |= std::uint64_t{1} << i % 64;
}
/// Calls `call` with the index of each set bit, and clears the bits.
template <class Call>
void takeBits(std::vector<std::uint64_t>& words, Call call) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        for (std::uint64_t bits = words[i]; bits != 0; bits &= bits - 1)
            call(static_cast<std::uint32_t>(i * 64 + static_cast<std::size_t>(std::countr_zero(bits))));
        words[i] = 0;
    }
}

/// Stores the locations of the proxies of one partition in the list of all proxies.
struct LocationList {
    std::span<ProxyLocation> places;  ///< location of each proxy
    std::uint32_t part = 0;

    void set(std::uint32_t id, std::uint32_t slot) const { places[id] = part << kPlaceBits | slot; }
};

/// Keeps proxies in three partitions of one type and tracks the location of each: implements a broad phase
/// except for findPairs(). A Part has numbered slots and
///
///   bool isDue(arrivals, moving)   true if sorting costs less than to add `arrivals` proxies and to move
///                                  `moving` others, and than the disorder that they would leave
///   sort(proxies, ids, moving, list)  replaces all proxies with these; sets their locations
///   add(proxies, ids, list)        stores more proxies; sets their locations
///   erase(place)
///   move(proxies, place)           reads the box and filter of the proxy again; returns its new slot
///   settle(searches)               called last; adds the time that so many searches lose by disorder
///   places(), size()               upper limit of the slots, number of proxies
///   isFree(place), idAt(place)
///   find(searches, box, sweep, mask, found)  query(); cast() if `sweep` (with bounds `box`) is not null
///   visitRegions(visit)
template <class Part>
class PartitionedBroadPhase : public BroadPhase {
public:
    void rebuild(const Proxies& proxies) final {
        places_.assign(proxies.bounds.size(), kNoLocation);
        arranged_.fill(kUnknown);
        for (auto& arrivals : arrivals_) arrivals.clear();
        for (std::uint32_t id = 0; id < proxies.bounds.size(); ++id) {
            if (const std::uint32_t part = partOf(proxies.motions[id]); part < kParts)
                arrivals_[part].push_back(id);
        }
        for (std::uint32_t i = 0; i < kParts; ++i) {
            parts_[i].sort(proxies, arrivals_[i], 0, listOf(i));
            parts_[i].settle(0);
        }
    }

    void update(const Proxies& proxies, std::span<const std::uint32_t> changed) final {
        if (changed.empty()) return;
        arranged_.fill(kUnknown);
        if (places_.size() < proxies.bounds.size()) places_.resize(proxies.bounds.size(), kNoLocation);
        const auto moving = sendToParts(proxies, changed);
        std::array<bool, kParts> isNew{};
        for (std::uint32_t i = 0; i < kParts; ++i) isNew[i] = take(i, proxies, arrivals_[i], moving[i]);
        for (const std::uint32_t id : changed) {
            const ProxyLocation place = places_[id];
            if (place == kNoLocation || isNew[partOfLocation(place)]) continue;
            const std::uint32_t part = partOfLocation(place);
            listOf(part).set(id, parts_[part].move(proxies, inPart(place)));
        }
        for (std::uint32_t i = 0; i < kParts; ++i) {
            parts_[i].settle(changed.size());
            if (take(i, proxies, {}, 0)) parts_[i].settle(0);
        }
    }

    /// Sorts by partition and slot. Proxies without a location come first.
    void arrange(std::span<std::uint32_t> moved) final {
        for (std::uint32_t i = 0; i < kParts; ++i) marks_[i].resize(parts_[i].places() / 64 + 1);
        arranged_ = {};
        std::size_t count = 0;
        for (const std::uint32_t id : moved) {
            const ProxyLocation place = placeOf(id);
            if (place == kNoLocation) {
                moved[count++] = id;
            } else {
                ++arranged_[partOfLocation(place)];
                setBit(marks_[partOfLocation(place)], inPart(place));
            }
        }
        for (std::uint32_t i = 0; i < kParts; ++i)
            takeBits(marks_[i], [&](std::uint32_t place) { moved[count++] = parts_[i].idAt(place); });
    }

    void query(const AABB& box, std::uint32_t mask, std::vector<std::uint32_t>& found) const final {
        find(usable(box), nullptr, mask, Among::All, found);
    }

    void cast(Vec2 from, Vec2 displacement, Vec2 half, std::uint32_t mask, std::vector<std::uint32_t>& found,
              Among among) const final {
        const LineSweep sweep = lineSweep(from, displacement, half);
        find(sweep.bounds, &sweep, mask, among, found);
    }

    void visitRegions(const std::function<void(const AABB&)>& visit) const final {
        for (const Part& part : parts_) part.visitRegions(visit);
    }

protected:
    [[nodiscard]] ProxyLocation placeOf(std::uint32_t id) const {
        return id < places_.size() ? places_[id] : kNoLocation;
    }
    /// True if the last arrange() included every proxy of a partition, and nothing has changed since.
    [[nodiscard]] bool areAllArranged(std::uint32_t part) const {
        return arranged_[part] == parts_[part].size();
    }

    std::array<Part, kParts> parts_;
    const BoxSearches& searches_ = boxSearchesFor(simdWidth());

private:
    LocationList listOf(std::uint32_t part) { return {places_, part}; }

    void find(const AABB& box, const LineSweep* sweep, std::uint32_t mask, Among among,
              std::vector<std::uint32_t>& found) const {
        if (box == kNowhere) return;
        for (const Part& part : std::span{parts_}.first(among == Among::Static ? kStaticPart + 1 : kParts))
            if (part.size() > 0) part.find(searches_, box, sweep, mask, found);
    }

    /// Removes proxies from partitions that they left, and collects the arrivals of each partition.
    /// @return  per partition: the number of changed proxies that stay in it
    std::array<std::uint32_t, kParts> sendToParts(const Proxies& proxies,
                                                  std::span<const std::uint32_t> changed) {
        for (auto& arrivals : arrivals_) arrivals.clear();
        std::array<std::uint32_t, kParts> moving{};
        for (const std::uint32_t id : changed) {
            const std::uint32_t wanted = partOf(proxies.motions[id]);
            const ProxyLocation place = places_[id];
            if (place != kNoLocation) {
                if (partOfLocation(place) == wanted) {
                    ++moving[wanted];
                    continue;
                }
                parts_[partOfLocation(place)].erase(inPart(place));
                places_[id] = kNoLocation;
            }
            if (wanted < kParts) arrivals_[wanted].push_back(id);
        }
        return moving;
    }

    /// Adds proxies to a partition, or sorts all of it if that is due.
    /// @return  true if all proxies of the partition were read again
    bool take(std::uint32_t i, const Proxies& proxies, std::span<std::uint32_t> arrivals,
              std::uint32_t moving) {
        Part& part = parts_[i];
        if (!part.isDue(arrivals.size(), moving)) {
            if (!arrivals.empty()) part.add(proxies, arrivals, listOf(i));
            return false;
        }
        order_.clear();
        for (std::uint32_t place = 0; place < part.places(); ++place) {
            if (!part.isFree(place)) order_.push_back(part.idAt(place));
        }
        order_.insert(order_.end(), arrivals.begin(), arrivals.end());
        part.sort(proxies, order_, moving, listOf(i));
        return true;
    }

    static constexpr std::uint32_t kUnknown = 0xffffffffu;

    std::vector<ProxyLocation> places_;             ///< location of each proxy
    std::vector<std::uint32_t> order_;              ///< ids of a partition, during its sort
    std::array<std::uint32_t, kParts> arranged_{};  ///< number of ids in the last arrange(), or kUnknown
    std::array<std::vector<std::uint32_t>, kParts> arrivals_;  ///< per partition: proxies to add
    std::array<std::vector<std::uint64_t>, kParts> marks_;     ///< one bit per slot; all 0 between calls
};

// The broad phases, for the table in broad_phase.cpp.
std::unique_ptr<BroadPhase> makeTree();
std::unique_ptr<BroadPhase> makeGrid();
std::unique_ptr<BroadPhase> makeSweepAndPrune();
std::unique_ptr<BroadPhase> makeQuadtree();

}  // namespace plumb::physics
