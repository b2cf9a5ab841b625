#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/box_searches.hpp"
#include "physics/broadphase/loose_quadtree.hpp"
#include "physics/broadphase/proxy_partitions.hpp"

namespace plumb::physics {

/// Loose quadtrees. A step never sorts all proxies again (unless most are new): the best choice where many
/// proxies come and go and no single step may be slow.
class QuadtreeBroadPhase final : public BroadPhase {
public:
    explicit QuadtreeBroadPhase(const BoxSearches&) {}

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
    ProxyPartitions<LooseQuadtree> proxies_;
};

}  // namespace plumb::physics
