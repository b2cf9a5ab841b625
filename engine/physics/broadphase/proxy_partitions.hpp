#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/broadphase/regions.hpp"

namespace plumb::physics {

/// The three partitions of a broad phase. Resting proxies are kept apart from moving ones, so that they add
/// nothing to the cost of a step.
enum ProxyPart : std::uint32_t { kStaticPart, kAsleepPart, kMovingPart, kParts };

constexpr std::uint32_t partOf(ProxyMotion motion) {
    constexpr std::uint32_t kPart[] = {kParts, kStaticPart, kAsleepPart, kMovingPart, kMovingPart};
    return kPart[static_cast<std::size_t>(motion)];
}

/// True if all proxies of two partitions can pair (see canPair): one is the sleeping, the other then the
/// moving partition.
constexpr bool allCanPair(std::uint32_t own, std::uint32_t other) {
    return own == kAsleepPart || other == kAsleepPart;
}

/// The location of a proxy: the partition in the high 2 bits, its slot there in the others.
using ProxyPlace = std::uint32_t;
inline constexpr ProxyPlace kNoPlace = 0xffffffffu;
inline constexpr std::uint32_t kPlaceBits = 30;
constexpr std::uint32_t partOfPlace(ProxyPlace place) { return place >> kPlaceBits; }
constexpr std::uint32_t inPart(ProxyPlace place) { return place & ((1u << kPlaceBits) - 1); }

/// Keeps proxies in three partitions of one type and tracks the location of each. A Part has numbered slots
/// and
///
///   bool take(proxies, arrivals, moving, places, first)  adds arrivals, or rebuilds itself when that
///                                 is due: writes places[id] = first + slot of each proxy that it stored, and
///                                 returns true if it stored all of them again. Otherwise move() will be
///                                 called for `moving` of the others.
///   void erase(place)
///   uint32 move(proxies, place)   reads the box and filter of the proxy again; returns its new slot
///   void settle(searches)         called after all of these; adds up what disorder costs future searches
///   bool isDue(arrivals)          true if take() would rebuild
///   uint32 places()               upper limit of the slots
///   uint32 idAt(place)
///   uint32 size()                 number of proxies
///   void clear()
///   void visitRegions(visitor)    see regions.hpp
template <class Part>
class ProxyPartitions {
public:
    std::array<Part, kParts> parts;

    [[nodiscard]] std::span<const Part> partsAmong(Among among) const {
        return std::span<const Part>{parts}.first(among == Among::Static ? kStaticPart + 1 : kParts);
    }

    /// True if the last arrange() was given every proxy of a partition, and nothing changed since.
    [[nodiscard]] bool areAllArranged(std::uint32_t part) const {
        return arranged_[part] == parts[part].size();
    }

    [[nodiscard]] ProxyPlace placeOf(std::uint32_t id) const {
        return id < places_.size() ? places_[id] : kNoPlace;
    }

    void visitRegions(RegionVisitor& visitor) const {
        for (const Part& part : parts) part.visitRegions(visitor);
    }

    void rebuild(const Proxies& proxies) {
        for (Part& part : parts) part.clear();
        places_.assign(proxies.bounds.size(), kNoPlace);
        all_.resize(proxies.bounds.size());
        std::iota(all_.begin(), all_.end(), 0u);
        update(proxies, all_);
    }

    void update(const Proxies& proxies, std::span<const std::uint32_t> changed) {
        if (changed.empty()) return;
        arranged_ = {kNobody, kNobody, kNobody};
        if (places_.size() < proxies.bounds.size()) places_.resize(proxies.bounds.size(), kNoPlace);
        const auto moving = sendToParts(proxies, changed);
        std::array<bool, kParts> isNew{};
        for (std::uint32_t i = 0; i < kParts; ++i)
            isNew[i] = parts[i].take(proxies, arrivals_[i], moving[i], places_, i << kPlaceBits);
        for (const std::uint32_t id : changed) {
            const ProxyPlace place = places_[id];
            if (place == kNoPlace || isNew[partOfPlace(place)]) continue;
            places_[id] =
                partOfPlace(place) << kPlaceBits | parts[partOfPlace(place)].move(proxies, inPart(place));
        }
        for (std::uint32_t i = 0; i < kParts; ++i) {
            parts[i].settle(changed.size());
            if (!parts[i].isDue(0)) continue;
            parts[i].take(proxies, {}, 0, places_, i << kPlaceBits);
            parts[i].settle(0);
        }
    }

    /// Sorts by partition and slot. Proxies without a location come first.
    void arrange(std::span<std::uint32_t> moved) {
        for (std::uint32_t i = 0; i < kParts; ++i) marks_[i].resize(parts[i].places() / 64 + 1);
        arranged_ = {};
        std::size_t count = 0;
        for (const std::uint32_t id : moved) {
            const ProxyPlace place = placeOf(id);
            if (place == kNoPlace) {
                moved[count++] = id;
            } else {
                ++arranged_[partOfPlace(place)];
                marks_[partOfPlace(place)][inPart(place) / 64] |= std::uint64_t{1} << place % 64;
            }
        }
        for (std::uint32_t i = 0; i < kParts; ++i) {
            for (std::size_t word = 0; word < marks_[i].size(); ++word) {
                for (std::uint64_t bits = marks_[i][word]; bits != 0; bits &= bits - 1)
                    moved[count++] = parts[i].idAt(static_cast<std::uint32_t>(
                        word * 64 + static_cast<std::size_t>(std::countr_zero(bits))));
                marks_[i][word] = 0;
            }
        }
    }

private:
    /// Removes proxies that changed their partition from the old one, and collects the arrivals of each
    /// partition.
    /// @return  by partition, how many of its own proxies changed
    std::array<std::uint32_t, kParts> sendToParts(const Proxies& proxies,
                                                  std::span<const std::uint32_t> changed) {
        for (auto& arrivals : arrivals_) arrivals.clear();
        std::array<std::uint32_t, kParts + 1> moving{};
        for (const std::uint32_t id : changed) {
            const std::uint32_t wanted = partOf(proxies.motions[id]);
            const ProxyPlace place = places_[id];
            if (place != kNoPlace) {
                if (partOfPlace(place) == wanted) {
                    ++moving[wanted];
                    continue;
                }
                parts[partOfPlace(place)].erase(inPart(place));
                places_[id] = kNoPlace;
            }
            if (wanted < kParts) arrivals_[wanted].push_back(id);
        }
        return {moving[0], moving[1], moving[2]};
    }

    static constexpr std::uint32_t kNobody = 0xffffffffu;

    std::vector<ProxyPlace> places_;                ///< by proxy
    std::vector<std::uint32_t> all_;                ///< ids of all proxies, for rebuild()
    std::array<std::uint32_t, kParts> arranged_{};  ///< proxies of it in the last arrange(), or kNobody
    std::array<std::vector<std::uint32_t>, kParts> arrivals_;
    std::array<std::vector<std::uint64_t>, kParts> marks_;  ///< bits, by slot; all 0 between calls
};

}  // namespace plumb::physics
