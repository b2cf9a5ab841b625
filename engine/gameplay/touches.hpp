#pragma once

#include "ecs/world.hpp"
#include "scene/physics/contact_events.hpp"

namespace plumb {

/// Calls `visit(trigger, other)` for every overlap event of this tick whose trigger entity has a T and whose
/// other entity has a U. Entities that an earlier visit destroyed are skipped.
template <class Event, class T, class U, class Visit>
void forEachTouch(World& world, Visit visit) {
    if (world.count<T>() == 0) return;
    for (const Event& touch : world.events<Event>()) {
        if (world.has<T>(touch.trigger) && world.has<U>(touch.other)) visit(touch.trigger, touch.other);
    }
}

/// Returns the world bounds of an entity's BoxCollider (px),
/// ignoring rotation. @pre the entity has a BoxCollider
AABB boxOf(const World& world, EntityId entity);

/// Sets a parameter of an Animator's state machine by name; does nothing if there is no such parameter.
void setParameter(World& world, EntityId entity, std::string_view name, float value);

}  // namespace plumb
