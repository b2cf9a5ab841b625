#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/random.hpp"
#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics::test {

/// Proxies for tests of broad phases, with the expected results computed by brute force.
struct ProxyWorld {
    std::vector<AABB> bounds;
    std::vector<Filter> filters;
    std::vector<ProxyMotion> motions;
    std::vector<std::uint32_t> changed;   ///< proxies added or changed since the last call of clearChanged()
    std::vector<std::uint8_t> isChanged;  ///< per proxy: 1 if it is in `changed`

    [[nodiscard]] Proxies proxies() const { return {bounds, filters, motions}; }
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(bounds.size()); }

    std::uint32_t add(const AABB& box, ProxyMotion motion = ProxyMotion::Awake, Filter filter = {}) {
        const std::uint32_t id = size();
        bounds.push_back(box);
        filter.body = filter.body == 0 ? id + 1 : filter.body;
        filters.push_back(filter);
        motions.push_back(motion);
        isChanged.push_back(0);
        touch(id);
        return id;
    }
    void touch(std::uint32_t id) {
        if (isChanged[id] == 0) changed.push_back(id);
        isChanged[id] = 1;
    }
    void move(std::uint32_t id, const AABB& box) {
        bounds[id] = box;
        touch(id);
    }
    void become(std::uint32_t id, ProxyMotion motion) {
        motions[id] = motion;
        touch(id);
    }
    void clearChanged() {
        for (const std::uint32_t id : changed) isChanged[id] = 0;
        changed.clear();
    }

    /// Returns the sorted keys of all expected pairs with at least one changed proxy.
    [[nodiscard]] std::vector<PairKey> pairsOfChanged() const {
        std::vector<PairKey> pairs;
        for (const std::uint32_t a : changed) {
            for (std::uint32_t b = 0; b < size(); ++b) {
                if (b == a || (isChanged[b] != 0 && b < a)) continue;
                if (makePair(a, b)) pairs.push_back(pairKey(a, b));
            }
        }
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    [[nodiscard]] std::vector<std::uint32_t> inBox(const AABB& box, std::uint32_t mask) const {
        std::vector<std::uint32_t> found;
        for (std::uint32_t id = 0; id < size(); ++id) {
            if (motions[id] != ProxyMotion::Gone && overlap(bounds[id], box) &&
                (filters[id].layers & mask) != 0)
                found.push_back(id);
        }
        return found;
    }

    [[nodiscard]] bool makePair(std::uint32_t a, std::uint32_t b) const {
        if (motions[a] == ProxyMotion::Gone || motions[b] == ProxyMotion::Gone) return false;
        const auto movable = [&](std::uint32_t id) {
            return motions[id] == ProxyMotion::Awake || motions[id] == ProxyMotion::Asleep;
        };
        const auto moves = [&](std::uint32_t id) {
            return motions[id] == ProxyMotion::Awake || motions[id] == ProxyMotion::Kinematic;
        };
        if ((!movable(a) && !movable(b)) || (!moves(a) && !moves(b))) return false;
        return overlap(bounds[a], bounds[b]) && mayCollide(filters[a], filters[b]);
    }

    /// True if two boxes overlap. Inverted boxes and boxes with a NaN overlap nothing.
    static bool overlap(const AABB& a, const AABB& b) {
        const auto real = [](const AABB& box) { return box.min.x <= box.max.x && box.min.y <= box.max.y; };
        return real(a) && real(b) && a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y &&
               b.min.y <= a.max.y;
    }
};

inline AABB boxAt(Vec2 centre, Vec2 half) { return {centre - half, centre + half}; }

/// Distribution of the sizes and positions of the boxes of a random world; see randomBox().
enum class BoxStatistics : std::uint8_t { Even, Crowds, Sizes, Column, Lattice, Spot, Giants, Far, Count };

/// Creates a box with random half extents and position.
inline AABB randomBox(Random& random, BoxStatistics spread) {
    const Vec2 half{random.between(0.0f, 0.6f), random.between(0.0f, 0.6f)};
    const Vec2 even{random.between(-8.0f, 8.0f), random.between(-8.0f, 8.0f)};
    switch (spread) {
        case BoxStatistics::Even: return boxAt(even, half);
        case BoxStatistics::Crowds: {
            const auto crowd = static_cast<float>(random.below(4));
            return boxAt(Vec2{crowd * 300.0f, crowd * crowd * -90.0f} + even * 0.3f, half);
        }
        case BoxStatistics::Sizes: {
            const float size = random.below(40) == 0 ? 40.0f : random.below(10) == 0 ? 3.0f : 0.1f;
            return boxAt(even, half * size);
        }
        case BoxStatistics::Column: return boxAt({even.x * 0.1f, even.y * 20.0f}, half);
        case BoxStatistics::Lattice: {  // many boxes only touch, many have zero size
            const Vec2 corner{static_cast<float>(random.below(16)), static_cast<float>(random.below(16))};
            const Vec2 size{static_cast<float>(random.below(3)), static_cast<float>(random.below(3))};
            return {corner, corner + size};
        }
        case BoxStatistics::Spot: return boxAt({3.0f, 3.0f}, half);
        case BoxStatistics::Giants:  // few boxes 1 km wide among many small ones
            return boxAt(even * 60.0f, random.below(50) == 0 ? Vec2{500.0f, 500.0f} : half * 0.1f);
        default: return boxAt(even + Vec2{1e6f, -1e6f}, half);
    }
}

inline Filter randomFilter(Random& random) {
    Filter filter;
    if (random.below(3) == 0) filter.layers = 1u << random.below(4);
    if (random.below(4) == 0) filter.mask = random.below(16);
    if (random.below(5) == 0) filter.group = static_cast<std::int32_t>(random.below(5)) - 2;
    if (random.below(4) == 0) filter.body = 1000000 + random.below(6);
    return filter;
}

inline ProxyMotion randomMotion(Random& random) {
    constexpr ProxyMotion kMotions[] = {ProxyMotion::Static,    ProxyMotion::Asleep, ProxyMotion::Asleep,
                                        ProxyMotion::Kinematic, ProxyMotion::Awake,  ProxyMotion::Awake,
                                        ProxyMotion::Awake,     ProxyMotion::Awake};
    return kMotions[random.below(8)];
}

}  // namespace plumb::physics::test
