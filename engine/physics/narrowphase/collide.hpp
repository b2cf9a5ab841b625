#pragma once
#include <span>
#include "physics/geometry.hpp"
#include "physics/narrowphase/manifold.hpp"
namespace plumb::physics {
Manifold collide(const Geometry& a, const Geometry& b, std::span<const Corner> corners, const Frame& bInA, float speculative);
}
