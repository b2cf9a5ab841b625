#include "scene/systems/particle_system.hpp"

#include <utility>

#include "scene/particles.hpp"

namespace plumb {

void ParticleSystem::update(World& world, float dt) {
    if (world.count<ParticleEmitter>() == 0) {
        if (auto* left = world.findResource<Particles>(); left != nullptr && !left->streams.empty())
            *left = {};
        return;
    }
    auto& particles = world.resource<Particles>();
    emitters_.clear();
    for (auto [entity, emitter] : std::as_const(world).query<const ParticleEmitter>(withPaused))
        emitters_.push_back(entity);
    followEmitters(particles, world, emitters_);
    const Vec2 gravity = particleGravity(world);
    for (auto [entity, emitter] : std::as_const(world).query<const ParticleEmitter>()) {
        ParticleStream* stream = particles.find(entity);
        const EmitterStep step{emitter, worldPose(world, entity, 0.0f), worldPose(world, entity), gravity,
                               dt};
        stepStream(particles, *stream, step);
    }
}

}  // namespace plumb
