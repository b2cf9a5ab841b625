#pragma once

#include "physics/model/geometry.hpp"
#include "physics/narrowphase/manifold.hpp"
#include "physics/solver/lanes.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

/// Eight pairs of boxes, each in the frame of its box A: the members of BoxPair (box_kernel.inl), in lanes.
struct BoxPairs {
    float halfAx[kLanes], halfAy[kLanes], halfBx[kLanes], halfBy[kLanes];
    float x[kLanes], y[kLanes];
    float cosine[kLanes], sine[kLanes];
    float radiusA[kLanes], radiusB[kLanes];
};

/// Their manifolds: the members of BoxTouch, in lanes.
struct BoxTouches {
    float normalX[kLanes], normalY[kLanes];
    float pointX[2][kLanes], pointY[2][kLanes], separation[2][kLanes], id[2][kLanes];
    float count[kLanes];
    float roundA[kLanes], roundB[kLanes];
};

void putPair(BoxPairs& pairs, int lane, const Geometry& a, const Geometry& b, const Frame& bInA);
/// @param a  the first box of the pair
[[nodiscard]] Manifold manifoldOf(const BoxTouches& touches, int lane, const Geometry& a);

}  // namespace plumb::physics
