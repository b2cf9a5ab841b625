#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/box_searches.hpp"
#include "physics/broadphase/bvh8.hpp"
#include "physics/broadphase/proxy_partitions.hpp"

namespace plumb::physics {

/// Trees of bounding boxes with eight children per node. The default: no distribution of sizes and positions
/// degrades it.
class TreeBroadPhase final : public BroadPhase {
public:
    explicit TreeBroadPhase(const BoxSearches& searches) : searches_{searches} {}

    void rebuild(const Proxies& proxies) override { proxies_.rebuild(proxies); }
    void update(const Proxies& proxies, std::span<const std::uint32_t> changed) override {
        proxies_.update(proxies, changed);
    }
    void arrange(std::span<std::uint32_t> moved) override { proxies_.arrange(moved); }
    void findPairs(const Proxies& proxies, std::span<const std::uint32_t> moved,
                   std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const override;
    void query(const Proxies& proxies, const AABB& box, std::uint32_t mask,
               std::vector<std::uint32_t>& found) const override;
    void cast(const Proxies& proxies, Vec2 from, Vec2 displacement, Vec2 half, std::uint32_t mask,
              std::vector<std::uint32_t>& found, Among among) const override;
    void visitRegions(RegionVisitor& visitor) const { proxies_.visitRegions(visitor); }

private:
    const BoxSearches& searches_;
    ProxyPartitions<Bvh8> proxies_;
};

}  // namespace plumb::physics
