#pragma once

#include "box_physics/settings.hpp"
#include "box_physics/world.hpp"

namespace plumb {
class Profile;
}

namespace plumb::box_physics {

/// What a step does. Stages that nothing calls for are not run and cost nothing.
enum Effect : unsigned {
    kGravity = 1,   ///< velocities grow by gravity
    kMotion = 2,    ///< bodies move by their velocity
    kContacts = 4,  ///< solid bodies stop, push and bounce each other
    kTriggers = 8,  ///< triggers report who overlaps them
    kAllEffects = 15,
};

/// Moves the world on by dt (s). Zero does nothing but clear the events.
/// @param profile  where the time of each stage is added, by its name; may be null
/// @pre dt is finite and not negative
void step(World& world, const Settings& settings, float dt, unsigned effects = kAllEffects,
          Profile* profile = nullptr);

/// "Up": against gravity, or screen up where there is none.
Vec2 upOf(const Settings& settings);

}  // namespace plumb::box_physics
