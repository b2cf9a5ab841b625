#pragma once

#include <cstdint>
#include <vector>

#include "physics/body.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

using SoftBodyId = Id<struct SoftBody>;

struct SoftParticle {
    Place place;               ///< m
    Place before;              ///< m: at the start of the substep
    Vec2 velocity;             ///< m/s
    float inverseMass = 0.0f;  ///< 1/kg; 0 for one that is pinned
    float mass = 0.0f;         ///< kg
};

/// Keeps two particles at a distance.
struct SoftLink {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    float length = 0.0f;      ///< m
    float compliance = 0.0f;  ///< m/N
};

/// A rope, a cloth or a jelly. Particles and their constraints.
struct SoftBody {
    std::vector<SoftParticle> particles;
    std::vector<SoftLink> links;
    std::vector<std::uint32_t> edges;  ///< links that particles of others do not pass
    std::vector<std::uint32_t> ring;   ///< particles around the area that is kept; empty for none
    float area = 0.0f;                 ///< m2, with the sign of the ring's sense
    float areaCompliance = 0.0f;
    float radius = 0.0f;   ///< m
    float damping = 0.0f;  ///< 1/s
    float friction = 0.0f;
    std::uint32_t layers = 1;
    std::uint32_t mask = 0xffffffffu;
    std::uint32_t generation = 0;
    std::uint8_t substeps = 8;
    bool isAlive = false;
};

}  // namespace plumb::physics
