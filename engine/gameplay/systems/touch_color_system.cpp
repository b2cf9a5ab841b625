#include "gameplay/systems/touch_color_system.hpp"

#include "gameplay/components/triggers/touch_color.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

namespace {

void enter(World& world, EntityId id) {
    TouchColor& touch = world.get<TouchColor>(id);
    Sprite* sprite = world.find<Sprite>(id);
    if (touch.touched++ > 0 || sprite == nullptr) return;
    touch.before = sprite->tint;
    sprite->tint = touch.color;
}

void leave(World& world, EntityId id) {
    TouchColor& touch = world.get<TouchColor>(id);
    Sprite* sprite = world.find<Sprite>(id);
    if (touch.touched == 0 || --touch.touched > 0 || sprite == nullptr) return;
    sprite->tint = touch.before;
}

}  // namespace

void TouchColorSystem::update(World& world, float) {
    if (world.count<TouchColor>() == 0) return;
    // Leave before enter, so that a body that moves from one trigger to another in one tick keeps the color.
    forEachTouch<TriggerLeft, Transform, TouchColor>(
        world, [&world](EntityId, EntityId visitor) { leave(world, visitor); });
    forEachTouch<TriggerEntered, Transform, TouchColor>(
        world, [&world](EntityId, EntityId visitor) { enter(world, visitor); });
}

}  // namespace plumb
