#include "gameplay/systems/detonator_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/components/triggers/detonator.hpp"
#include "gameplay/named_action.hpp"
#include "gameplay/sound_cue.hpp"
#include "input/input.hpp"
#include "math/portable.hpp"
#include "scene/components/fields/explosion.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

namespace {

bool isDue(World& world, EntityId id, Detonator& detonator) {
    ++detonator.ticks;
    const bool byItself = detonator.after > 0.0f &&
                          detonator.ticks == static_cast<std::uint32_t>(floorToInt(detonator.after * 60.0f));
    return byItself || inputFor(world, id).isPressed(actionNamed(detonator.action));
}

}  // namespace

void DetonatorSystem::update(World& world, float) {
    for (auto [entity, detonator] : world.query<Detonator>()) {
        if (!isDue(world, entity, detonator) || world.has<Explosion>(entity)) continue;
        Explosion explosion;
        explosion.radius = detonator.radius;
        explosion.impulse = detonator.speed;
        world.add<Explosion>(entity, explosion);
        playCue(world, entity, &SoundCues::activate);
    }
}

}  // namespace plumb
