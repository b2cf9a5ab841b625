#pragma once

#include "physics/model/geometry.hpp"
#include "physics/narrowphase/manifold.hpp"
#include "physics/solver/lanes.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// Eight pairs of boxes, each in a frame with the centre and the axes of its box A.
/// @tparam Row  eight numbers: in memory, or in a register of the kernel
template <class Row>
struct BoxPairOf {
    Row halfAx, halfAy, halfBx, halfBy;  // m
    Row x, y;                            // m: B's centre
    Row cosine, sine;                    // B's rotation
    Row radiusA, radiusB;                // m
};

/// Their manifolds.
template <class Row>
struct BoxTouchOf {
    Row normalX, normalY;  // from A to B
    Row pointX[2], pointY[2], separation[2];
    Row id[2];  // corner of A * 256 + corner of B; corners are 0 (-,-), 1 (+,-), 2 (-,+), 3 (+,+)
    Row count;
    Row roundA, roundB;
};

using BoxPairs = BoxPairOf<float[kLanes]>;
using BoxTouches = BoxTouchOf<float[kLanes]>;

void putPair(BoxPairs& pairs, int lane, const Geometry& a, const Geometry& b, const Frame& bInA);
/// @param a  the first box of the pair
[[nodiscard]] Manifold manifoldOf(const BoxTouches& touches, int lane, const Geometry& a);

}  // namespace plumb::physics
