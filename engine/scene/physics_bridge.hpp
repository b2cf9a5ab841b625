#pragma once

#include "ecs/world.hpp"
#include "physics/ids.hpp"

namespace plumb {

/// Makes bodies follow their components: creates, changes and destroys what differs. Costs only for what
/// changed. Kinematic bodies get the velocities that lead where this tick takes them.
/// Reads: Transform, RigidBody, KinematicBody, StaticBody, CharacterBody, colliders, TileLayer, joints,
/// fields.
/// @param dt  s
void syncBodies(World& world, float dt);

/// One tick of physics: sync, step, poses and velocities back into the components of bodies that moved,
/// contact events.
/// Writes: Transform, RigidBody; removes joints that broke and explosions; emits contact_events.hpp.
void stepPhysics(World& world, float dt);

/// The body of an entity, or the empty id.
physics::BodyId bodyOf(World& world, EntityId entity);

/// Makes tile colliders anew in the next sync, e.g. after a tileset was changed.
void rebuildTileColliders(World& world);

}  // namespace plumb
