#pragma once

#include <cstdint>
#include <vector>

#include "physics/ids.hpp"
#include "physics/model/body.hpp"

namespace plumb::physics {

using SoftBodyId = Id<struct SoftBody>;

struct SoftParticle {
    WorldPosition place;       ///< m
    WorldPosition before;      ///< m: at the start of the substep
    Vec2 velocity;             ///< m/s
    float inverseMass = 0.0f;  ///< 1/kg; 0 if it is pinned
    float mass = 0.0f;         ///< kg
};

/// Distance constraint between two particles.
struct SoftLink {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    float length = 0.0f;      ///< m
    float compliance = 0.0f;  ///< m/N
    bool isEdge = false;      ///< particles of other soft bodies collide with it
};

/// Force of a shape on a particle at the end of a step, with which the next one begins.
struct SoftTouch {
    std::uint32_t particle = 0;
    std::uint32_t shape = 0;
    Vec2 force;  ///< N
};

/// A rope, cloth or jelly: particles and their constraints.
struct SoftBody {
    std::vector<SoftParticle> particles;
    std::vector<SoftLink> links;
    std::vector<std::uint32_t> ring;  ///< particles around the area that is kept; empty for none
    std::vector<SoftTouch> touches;   ///< sorted by shape, then by particle
    float area = 0.0f;                ///< m2, at rest; positive or negative as the ring's orientation
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
