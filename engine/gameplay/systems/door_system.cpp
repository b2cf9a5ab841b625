#include "gameplay/systems/door_system.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ecs/world.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/controls/button.hpp"
#include "gameplay/components/triggers/door.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/sound_cue.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/physics/physics_queries.hpp"

namespace plumb {

namespace {

constexpr int kButtonTicks = 6;     // ticks after the last contact until a button is released
constexpr float kKeyReach = 2.0f;   // px, maximum distance from which a player opens a door with keys
constexpr std::uint8_t kOpen = 60;  // opacity of an open door

void press(World& world, EntityId id) {
    Button& button = world.get<Button>(id);
    button.held = kButtonTicks;
    if (button.pressed) return;
    button.pressed = true;
    setParameter(world, id, "pressed", 1.0f);
    playCue(world, id, &SoundCues::activate);
}

/// True if a body is on the button; needed because sleeping bodies emit no TriggerStayed.
bool isLoaded(World& world, EntityId button) {
    if (!std::as_const(world).has<BoxCollider>(button)) return false;
    std::vector<EntityId> found;
    overlapBox(world, boxOf(world, button), {}, found);
    return std::any_of(found.begin(), found.end(),
                       [&world](EntityId other) { return std::as_const(world).has<RigidBody>(other); });
}

void release(World& world) {
    for (auto [entity, button] : world.query<Button>()) {
        if (!button.pressed || button.stays || --button.held > 0) continue;
        if (isLoaded(world, entity)) {
            button.held = kButtonTicks;
            continue;
        }
        button.pressed = false;
        setParameter(world, entity, "pressed", 0.0f);
    }
}

void swing(World& world, EntityId id, bool open) {
    Door& door = world.get<Door>(id);
    if (door.open == open) return;
    door.open = open;
    if (auto* collider = world.find<BoxCollider>(id)) collider->isTrigger = open;
    if (auto* sprite = world.find<Sprite>(id)) sprite->tint.a = open ? kOpen : std::uint8_t{255};
    setParameter(world, id, "open", open ? 1.0f : 0.0f);
    playCue(world, id, &SoundCues::activate);
}

bool playerIsNear(World& world, EntityId door) {
    if (!world.has<BoxCollider>(door)) return false;
    const AABB near = grown(boxOf(world, door), kKeyReach);
    for (auto [entity, player] : world.query<const PlayerController>(with<BoxCollider>)) {
        if (intersects(near, boxOf(world, entity))) return true;
    }
    return false;
}

void tryKeys(World& world, EntityId id, const Door& door) {
    GameProgress& progress = world.resource<GameProgress>();
    if (door.open || door.keys <= 0 || progress.keys < door.keys || !playerIsNear(world, id)) return;
    progress.keys -= door.keys;
    swing(world, id, true);
}

}  // namespace

void DoorSystem::update(World& world, float) {
    if (world.count<Door>() == 0 && world.count<Button>() == 0) return;
    const auto visit = [&world](EntityId button, EntityId) { press(world, button); };
    forEachTouch<TriggerEntered, Button, RigidBody>(world, visit);
    forEachTouch<TriggerStayed, Button, RigidBody>(world, visit);
    release(world);
    for (auto [entity, door] : world.query<const Door>()) {
        const Button* button = std::as_const(world).find<Button>(door.button);
        if (button != nullptr) {
            swing(world, entity, button->pressed);
        } else {
            tryKeys(world, entity, door);
        }
    }
}

}  // namespace plumb
