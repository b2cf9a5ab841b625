#pragma once

#include "ecs/world.hpp"
#include "box_physics/body.hpp"

namespace plumb {

/// Makes bodies follow their components: creates, changes and destroys what differs. Cheap when nothing
/// does. Kinematic bodies learn where this tick takes them, so that queries see them there.
/// Reads: Transform, RigidBody, KinematicBody, StaticBody, CharacterBody, colliders, TileLayer.
/// @param dt  s
void syncBodies(World& world, float dt);

/// One tick of physics: sync, step, poses and velocities back into the components of bodies that moved,
/// contact events.
/// Writes: Transform, RigidBody; emits contact_events.hpp.
void stepPhysics(World& world, float dt);

/// Bits of box_physics::Effect that this world calls for: by its settings, else by its systems, else by its
/// components.
unsigned effectsOf(World& world);

/// The body of an entity, or nobody.
box_physics::BodyId bodyOf(World& world, EntityId entity);

/// Makes tile colliders anew in the next sync, e.g. after a tileset was changed.
void rebuildTileColliders(World& world);

}  // namespace plumb
