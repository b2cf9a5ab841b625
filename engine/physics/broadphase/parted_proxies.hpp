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

/// The three groups that a broad phase keeps apart: those who rest are never among those who move, so they
/// cost a step nothing.
enum ProxyPart : std::uint32_t { kStaticPart, kAsleepPart, kMovingPart, kParts };

constexpr std::uint32_t partOf(ProxyMotion motion) {
    constexpr std::uint32_t kPart[] = {kParts, kStaticPart, kAsleepPart, kMovingPart, kMovingPart};
    return kPart[static_cast<std::size_t>(motion)];
}

/// Whether all proxies of two parts can pair (see canPair): where one part is the sleeping, the other moves.
constexpr bool allCanPair(std::uint32_t own, std::uint32_t other) {
    return own == kAsleepPart || other == kAsleepPart;
}

/// Where a proxy is: the part in the high 2 bits, its place there in the others.
using ProxyPlace = std::uint32_t;
inline constexpr ProxyPlace kNoPlace = 0xffffffffu;
inline constexpr std::uint32_t kPlaceBits = 30;
constexpr std::uint32_t partOfPlace(ProxyPlace place) { return place >> kPlaceBits; }
constexpr std::uint32_t inPart(ProxyPlace place) { return place & ((1u << kPlaceBits) - 1); }

/// Keeps proxies in three parts of one kind and says where each is. A Part has numbered places and
///
///   bool take(proxies, arrivals, moving, places, first)  takes arrivals, or all anew when it is time to:
///                                 writes places[id] = first + place of whom it put somewhere, and says
///                                 whether that was everybody. `moving` others will move() if not.
///   void erase(place)
///   uint32 move(proxies, place)   reads the proxy's box and filter again; says where it is now
///   void settle(searches)         after all of these; counts what searches to come will lose by disorder
///   bool isDue(arrivals)          whether take() would take all anew
///   uint32 places()               more than any place
///   uint32 idAt(place)
///   uint32 size()                 how many it has
///   void clear()
///   void visitRegions(visitor)    see regions.hpp
template <class Part>
class PartedProxies {
public:
    std::array<Part, kParts> parts;

    [[nodiscard]] std::span<const Part> partsAmong(Among among) const {
        return std::span<const Part>{parts}.first(among == Among::Static ? kStaticPart + 1 : kParts);
    }

    /// Whether everybody of a part was in what arrange() was last given, and nothing changed since then.
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

    /// By part and place. Those who are nowhere come first.
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
    /// Takes those out of their parts that belong to another now, and collects who arrives.
    /// @return  by part, how many of its own changed
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
    std::vector<std::uint32_t> all_;                ///< of rebuild(), which may be a part of each step
    std::array<std::uint32_t, kParts> arranged_{};  ///< how many arrange() was last given; or kNobody
    std::array<std::vector<std::uint32_t>, kParts> arrivals_;
    std::array<std::vector<std::uint64_t>, kParts> marks_;  ///< bits, by place; all 0 between calls
};

}  // namespace plumb::physics
