#pragma once

#include "ecs/world.hpp"
#include "scene/physics/contact_events.hpp"

namespace plumb {

/// Calls `visit(trigger, other)` for every overlap of this tick whose trigger has a T and whose other has a
/// U. What an earlier visit destroyed is left out.
template <class Event, class T, class U, class Visit>
void forEachTouch(World& world, Visit visit) {
    if (world.count<T>() == 0) return;
    // By index: a visit may emit events of this type, which moves the list.
    for (std::size_t i = 0; i < world.events<Event>().size(); ++i) {
        const Event touch = world.events<Event>()[i];
        if (world.has<T>(touch.trigger) && world.has<U>(touch.other)) visit(touch.trigger, touch.other);
    }
}

/// The box of an entity's collider in the world (px). @pre it has Transform and BoxCollider
AABB boxOf(const World& world, EntityId entity);

/// Sets a parameter of an Animator's state machine by name; nothing happens where there is none.
void setParameter(World& world, EntityId entity, std::string_view name, float value);

}  // namespace plumb
