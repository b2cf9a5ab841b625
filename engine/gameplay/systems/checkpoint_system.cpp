#include "gameplay/systems/checkpoint_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "gameplay/components/triggers/checkpoint.hpp"
#include "gameplay/sound_cue.hpp"
#include "gameplay/touches.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

void CheckpointSystem::update(World& world, float) {
    forEachTouch<TriggerEntered, Checkpoint, Respawn>(world, [&world](EntityId touched, EntityId player) {
        Respawn& respawn = world.get<Respawn>(player);
        if (respawn.waiting > 0 || std::as_const(world).get<Checkpoint>(touched).active) return;
        for (auto [entity, checkpoint] : world.query<Checkpoint>()) {
            checkpoint.active = entity.id() == touched;
            setParameter(world, entity, "active", checkpoint.active ? 1.0f : 0.0f);
        }
        respawn.placed = true;
        respawn.place =
            worldPose(world, touched).position + std::as_const(world).get<Checkpoint>(touched).offset;
        playCue(world, touched, &SoundCues::activate);
    });
}

}  // namespace plumb
