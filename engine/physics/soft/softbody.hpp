#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Material of ropes, cloth and jellies.
struct SoftMaterial {
    float mass = 1.0f;     ///< kg, of the whole body
    float radius = 0.05f;  ///< m: distance that particles keep from shapes; two soft bodies keep the sum
    float stretchCompliance = 0.0f;    ///< m/N; at 0, 8 times its mass stretches a rope of 20 points by 10 %
    float bendCompliance = 1.0e-2f;    ///< m/N: larger is easier to bend; negative: no bending constraints
    float areaCompliance = 0.0f;       ///< m/N, of a jelly: larger is easier to compress
    float damping = 0.5f;              ///< 1/s: decay rate of its velocity
    float friction = 0.5f;             ///< Coulomb coefficient
    std::uint32_t layers = 1;          ///< bits: layers of the soft body
    std::uint32_t mask = 0xffffffffu;  ///< bits: layers of the shapes and soft bodies that it collides with
    std::uint8_t substeps = 8;         ///< substeps per step; more make it stiffer
};

/// Creates a rope: a straight chain of particles, the first at `from`, the last at `to` (m).
/// @param count  number of particles, 2..10000
Result<SoftBodyId> createRope(World& world, WorldPosition from, WorldPosition to, int count,
                              const SoftMaterial& material = {});
/// Creates a cloth. Particle (column, row) has the index row * columns + column; (0, 0) is at `corner`.
/// @param size  m: displacement to the opposite corner
/// @param columns, rows  2..200 each
Result<SoftBodyId> createCloth(World& world, WorldPosition corner, Vec2 size, int columns, int rows,
                               const SoftMaterial& material = {});
/// Creates a jelly: a closed outline that keeps its area.
/// @param outline  m, relative to `place`; 3..500 points, one particle each; must not intersect itself
Result<SoftBodyId> createJelly(World& world, WorldPosition place, std::span<const Vec2> outline,
                               const SoftMaterial& material = {});
/// Destroys a soft body. A stale id does nothing.
void destroySoftBody(World& world, SoftBodyId body);

/// Returns a soft body, or one without particles if it was destroyed.
[[nodiscard]] inline const SoftBody& softBodyOf(const World& world, SoftBodyId body) {
    return readOf(world, world.softBodies.all, body);
}
[[nodiscard]] inline std::span<const SoftParticle> particlesOf(const World& world, SoftBodyId body) {
    return softBodyOf(world, body).particles;
}

/// Fixes a particle in its position, or releases it.
Result<Done> pinParticle(World& world, SoftBodyId body, int particle, bool pinned);
/// Moves a particle; a pinned one drags its neighbors along. Before each step: fastens them to a body.
Result<Done> moveParticle(World& world, SoftBodyId body, int particle, WorldPosition place);
/// @param velocity  m/s; ignored by pinned particles
Result<Done> setParticleVelocity(World& world, SoftBodyId body, int particle, Vec2 velocity);

}  // namespace plumb::physics
