#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// A body at the moment of an impact.
struct ImpactBody {
    BodyPose pose;
    BodyMotion motion;
    BodyMass mass;  ///< inverse mass 0 if it is static or kinematic
};

/// Applies the impulses of an impact, with friction and restitution, to the two bodies of a contact, and
/// stores them in the contact. Never adds energy, whatever the outlines and masses.
/// @param contact  its points at these poses
/// @param timeLeft  s of the step after the impact: a second point that is still separated may close its gap
/// in this time, but not sooner; a body that lands nearly flat lands on both points
void exchangeImpulses(Contact& contact, ImpactBody& a, ImpactBody& b, float timeLeft,
                      const Settings& settings);

}  // namespace plumb::physics
