#pragma once

#include "physics/broadphase/loose_quadtree.hpp"
#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

/// Loose quadtrees. A step never sorts all proxies again (unless most are new): the best choice where many
/// proxies come and go and no single step may be slow.
class QuadtreeBroadPhase final : public PartitionedBroadPhase<LooseQuadtree> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override;
};

}  // namespace plumb::physics
