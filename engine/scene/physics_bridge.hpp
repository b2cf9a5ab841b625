#pragma once

#include "ecs/world.hpp"
#include "physics/ids.hpp"

namespace plumb {

/// Synchronizes bodies with their components: creates, changes and destroys bodies.
/// The cost depends on the number of changes. Kinematic bodies get the velocities that
/// move them to the poses of their Transforms in this tick. Reads: Transform, RigidBody,
/// KinematicBody, StaticBody, CharacterBody, colliders, TileLayer, joints, fields.
/// @param dt  s, length of the tick
void syncBodies(World& world, float dt);

/// Runs one tick of physics: synchronizes bodies, steps, writes poses and velocities of moved bodies back to
/// their components, emits contact events. Writes: Transform, RigidBody; removes joints that broke and
/// explosions; emits the events of contact_events.hpp.
void stepPhysics(World& world, float dt);

/// Returns the body of an entity, or the empty id.
physics::BodyId bodyOf(World& world, EntityId entity);

/// Recreates tile colliders in the next sync, e.g. after a tileset was changed.
void rebuildTileColliders(World& world);

}  // namespace plumb
