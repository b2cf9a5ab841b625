#pragma once

#include <cstdint>
#include <vector>

#include "core/hash.hpp"
#include "core/state_archive.hpp"
#include "ecs/world.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

/// Particles of one emitter: a range in the arrays of Particles, oldest first, and the emitter's progress.
struct ParticleStream {
    EntityId emitter;
    std::uint64_t seed = 0;      ///< seed of the random numbers, combined with `born`
    std::uint32_t born = 0;      ///< number of particles emitted since the emitter was created
    float time = 0.0f;           ///< s since the start of the emission cycle
    float owed = 0.0f;           ///< fraction of a particle that is due, carried over to the next step
    bool begun = false;          ///< false: the next tick starts the first cycle
    bool wanted = false;         ///< in followEmitters(): its emitter still exists
    std::uint32_t first = 0;     ///< index of the first particle in the arrays
    std::uint32_t count = 0;     ///< number of particles alive
    std::uint32_t capacity = 0;  ///< number of elements reserved in the arrays
};

/// All particles of a world, as structure of arrays. A world resource that exists only if a scene has
/// emitters. It is part of snapshots and of the hash, so a restored state shows the same particles.
struct Particles {
    std::vector<ParticleStream> streams;  ///< sorted by emitter entity
    std::vector<float> x;                 ///< px, position in the emitter's particle space
    std::vector<float> y;                 ///< px, position in the emitter's particle space
    std::vector<float> velocityX;         ///< px/s
    std::vector<float> velocityY;         ///< px/s
    std::vector<float> progress;          ///< age as a ratio of the lifetime, 0..1
    std::vector<float> pace;              ///< 1/s: 1 / lifetime
    std::vector<float> size;              ///< ratio to the emitter's size
    std::vector<float> turn;              ///< rad, rotation at birth
    std::vector<float> spin;              ///< rad, rotation over the whole lifetime

    [[nodiscard]] ParticleStream* find(EntityId emitter);
    [[nodiscard]] const ParticleStream* find(EntityId emitter) const {
        return const_cast<Particles*>(this)->find(emitter);
    }
    [[nodiscard]] std::size_t alive() const;

    void addTo(Hasher& hasher) const;
    void archive(StateArchive& archive);
};

/// Exact motion of a particle under gravity and drag over any time: the velocity becomes `velocity * keep +
/// pull`, the position changes by `velocity * reach + fall`.
struct ParticleTravel {
    float keep = 1.0f;   ///< ratio
    float reach = 0.0f;  ///< s
    Vec2 pull;           ///< px/s
    Vec2 fall;           ///< px

    /// @param gravity  px/s^2
    /// @param drag     1/s
    static ParticleTravel over(float seconds, Vec2 gravity, float drag);
};

/// Returns the gravity for particles of a world (px/s^2), before the emitter's ratio is applied.
[[nodiscard]] Vec2 particleGravity(const World& world);
/// Returns the gravity in the emitter's particle space, times its ratio (px/s^2). @param pose  of the emitter
[[nodiscard]] Vec2 gravityIn(const ParticleEmitter& emitter, const Pose& pose, Vec2 gravity);

/// Creates a stream for every new emitter and removes those of destroyed emitters. Allocates only if more
/// capacity is needed than ever before. @param emitters  all emitters, in any order
void followEmitters(Particles& particles, const World& world, std::span<const EntityId> emitters);

/// Input of one step of one emitter.
struct EmitterStep {
    const ParticleEmitter& emitter;
    Pose from;     ///< world pose of the emitter at the start of the step
    Pose to;       ///< world pose of the emitter at the end of the step
    Vec2 gravity;  ///< px/s^2, gravity of the scene
    float dt;      ///< s, length of the step
};
/// Moves the particles of a stream, removes expired ones, emits those that are due.
void stepStream(Particles& particles, ParticleStream& stream, const EmitterStep& step);

/// Emits `count` particles at once, at the end of the step.
void burstStream(Particles& particles, ParticleStream& stream, const EmitterStep& step, int count);

}  // namespace plumb
