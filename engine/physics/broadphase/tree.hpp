#pragma once

#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

/// Trees of bounding boxes with eight children per node. The default: no distribution of sizes and positions
/// degrades it.
class TreeBroadPhase final : public PartitionedBroadPhase<Bvh8> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override;
};

}  // namespace plumb::physics
