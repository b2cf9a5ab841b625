#pragma once

#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics {

/// Is given the regions that a broad phase sorts proxies into, for looking at.
class RegionVisitor {
public:
    virtual ~RegionVisitor() = default;
    virtual void region(const AABB& bounds) = 0;
};

/// Shows the nodes, cells or stretches that have somebody in them.
/// @pre it was made by makeBroadPhase(kind)
void visitRegions(const BroadPhase& broadPhase, BroadPhaseKind kind, RegionVisitor& visitor);

}  // namespace plumb::physics
