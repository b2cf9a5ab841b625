#pragma once

#include <cstdint>
#include <vector>

#include "core/hash.hpp"
#include "ecs/world.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

/// What one emitter has sent: a range of the arrays of Particles, oldest first, and how far it is.
struct ParticleStream {
    EntityId emitter;
    std::uint64_t seed = 0;      ///< of its random numbers, with `born`
    std::uint32_t born = 0;      ///< since it began
    float time = 0.0f;           ///< s of this turn
    float owed = 0.0f;           ///< particles: the part of the next one that is due already
    bool begun = false;          ///< false: the next tick is its first
    bool wanted = false;         ///< while streams follow emitters: its emitter is still there
    std::uint32_t first = 0;     ///< place in the arrays
    std::uint32_t count = 0;     ///< alive
    std::uint32_t capacity = 0;  ///< places that are its own
};

/// All particles of a world, in plain arrays. A resource that is there only where a scene has emitters. It is
/// part of snapshots and of the hash, so the past is shown with the very particles that it had.
struct Particles {
    std::vector<ParticleStream> streams;  ///< by entity
    std::vector<float> x;                 ///< px, in the world or in the emitter
    std::vector<float> y;                 ///< px
    std::vector<float> velocityX;         ///< px/s
    std::vector<float> velocityY;         ///< px/s
    std::vector<float> progress;          ///< ratio of the life that is over, 0..1
    std::vector<float> pace;              ///< 1/s: one through the length of the life
    std::vector<float> size;              ///< ratio of the emitter's
    std::vector<float> turn;              ///< rad, at birth
    std::vector<float> spin;              ///< rad in the whole life

    [[nodiscard]] ParticleStream* find(EntityId emitter);
    [[nodiscard]] const ParticleStream* find(EntityId emitter) const {
        return const_cast<Particles*>(this)->find(emitter);
    }
    [[nodiscard]] std::size_t alive() const;

    void addTo(Hasher& hasher) const;
};

/// How far a particle comes in some time under gravity and drag: exact, however long the time is.
/// Velocity becomes `velocity * keep + pull`, the place moves by `velocity * reach + fall`.
struct ParticleTravel {
    float keep = 1.0f;   ///< ratio
    float reach = 0.0f;  ///< s
    Vec2 pull;           ///< px/s
    Vec2 fall;           ///< px

    /// @param gravity  px/s^2
    /// @param drag     1/s
    static ParticleTravel over(float seconds, Vec2 gravity, float drag);
};

/// The gravity that particles feel in a world (px/s^2), before the emitter's own part of it.
[[nodiscard]] Vec2 particleGravity(const World& world);
/// Gravity as a stream's own space has it (px/s^2). @param pose  of the emitter
[[nodiscard]] Vec2 gravityIn(const ParticleEmitter& emitter, const Pose& pose, Vec2 gravity);

/// Gives every emitter its stream and takes away those of emitters that are gone. Allocates only when
/// more room is wanted than ever before. @param emitters  all of them, in any order
void followEmitters(Particles& particles, const World& world, std::span<const EntityId> emitters);

/// One emitter in one step.
struct EmitterStep {
    const ParticleEmitter& emitter;
    Pose from;     ///< in the world, when the step begins
    Pose to;       ///< and when it ends
    Vec2 gravity;  ///< px/s^2 of the scene
    float dt;      ///< s
};
/// Moves what a stream has, takes out what has lived, sends what is due.
void stepStream(Particles& particles, ParticleStream& stream, const EmitterStep& step);

/// Sends so many at once, at the end of the step.
void burstStream(Particles& particles, ParticleStream& stream, const EmitterStep& step, int count);

}  // namespace plumb
