#pragma once

#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics {

/// Receives the regions into which a broad phase sorts proxies, for debug drawing.
class RegionVisitor {
public:
    virtual ~RegionVisitor() = default;
    virtual void region(const AABB& bounds) = 0;
};

/// Visits the nodes, cells or segments that are in use.
/// @pre the broad phase was created by makeBroadPhase(kind)
void visitRegions(const BroadPhase& broadPhase, BroadPhaseKind kind, RegionVisitor& visitor);

}  // namespace plumb::physics
