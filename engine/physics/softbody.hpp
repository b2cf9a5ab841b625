#pragma once

#include <span>

#include "core/result.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// What ropes, cloth and jellies are made of.
struct SoftMaterial {
    float mass = 1.0f;                 ///< kg, of the whole body
    float radius = 0.05f;              ///< m: how far it stays from shapes, and from others besides theirs
    float stretchCompliance = 0.0f;    ///< m/N: 0 does not stretch
    float bendCompliance = 1.0e-2f;    ///< m/N: larger bends more easily; below 0 it does not resist at all
    float areaCompliance = 0.0f;       ///< m/N, of a jelly: larger is squeezed more easily
    float damping = 0.5f;              ///< 1/s: of its motion through space
    float friction = 0.5f;             ///< Coulomb coefficient
    std::uint32_t layers = 1;          ///< bits: what it is
    std::uint32_t mask = 0xffffffffu;  ///< bits: the layers of the shapes and soft bodies that it meets
    std::uint8_t substeps = 8;         ///< of a step; more is stiffer
};

/// A row of particles, tied one to the next.
/// @param count  of particles, 2..10000
Result<SoftBodyId> createRope(World& world, Place from, Place to, int count,
                              const SoftMaterial& material = {});
/// A net of particles. Particle (column, row) has the number row * columns + column; (0, 0) is at `corner`.
/// @param size           m: way to the opposite corner
/// @param columns, rows  2..200 each
Result<SoftBodyId> createCloth(World& world, Place corner, Vec2 size, int columns, int rows,
                               const SoftMaterial& material = {});
/// A skin around an area that it keeps.
/// @param outline  m, around `place`; 3..500 points, each of which becomes a particle; crosses itself nowhere
Result<SoftBodyId> createJelly(World& world, Place place, std::span<const Vec2> outline,
                               const SoftMaterial& material = {});
/// A stale id does nothing.
void destroySoftBody(World& world, SoftBodyId body);

[[nodiscard]] bool alive(const World& world, SoftBodyId body);
/// @pre the body is alive
[[nodiscard]] std::span<const SoftParticle> particlesOf(const World& world, SoftBodyId body);
[[nodiscard]] const SoftBody& softBodyOf(const World& world, SoftBodyId body);

/// Holds a particle where it is, whatever pulls at it, or lets it go.
Result<Done> pinParticle(World& world, SoftBodyId body, int particle, bool pinned);
/// Moves a particle; a pinned one takes its neighbours along.
Result<Done> moveParticle(World& world, SoftBodyId body, int particle, Place place);
/// @param velocity  m/s; a pinned one stays where it is
Result<Done> setParticleVelocity(World& world, SoftBodyId body, int particle, Vec2 velocity);

}  // namespace plumb::physics
