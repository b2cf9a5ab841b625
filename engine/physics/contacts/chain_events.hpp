#pragma once

#include "physics/workspace.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// Shapes with one ShapeDefinition::surface form a chain, whose seams should not cause events. Contacts
// between a chain and what touches it are therefore counted: the first one to begin is an event, and so is
// the last one to end, decided at the end of the step, when it is known which contacts replaced others.

/// Makes an event of what happened to a contact, if it is reported: at once, or for chains in
/// publishSurfaces().
/// @param impulse  N s, see ContactEvent
void report(World& world, Workspace& work, const Contact& contact, ContactPhase phase, float impulse = 0.0f);

/// Notes how fast two bodies with these motions come together at a contact, for its event.
void noteApproach(const World& world, Workspace& work, const Contact& contact, const BodyMotion& a,
                  const BodyMotion& b);

/// Makes the events of chains. Part of publishEvents().
void publishSurfaces(World& world, Workspace& work);

/// Recounts all contacts of chains, after the world was overwritten.
void countSurfaces(const World& world, Workspace& work);

}  // namespace plumb::physics
