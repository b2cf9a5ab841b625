#pragma once

#include "physics/contact.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// A body at the moment of an impact.
struct ImpactBody {
    BodyPose pose;
    BodyMotion motion;
    BodyMass mass;  ///< its inverse mass is 0 for what cannot be pushed
};

/// Exchanges the impulses of an impact between the bodies of a contact, with its friction and bounciness, and
/// writes them to the contact. Never adds energy, whatever the outlines and masses.
/// @param contact   its points as they are in these poses
/// @param timeLeft  s of the step after the impact: a second point that is still apart may close its gap in
///                  that time, and no sooner; what lands nearly flat lands on both points
void exchangeImpulses(Contact& contact, ImpactBody& a, ImpactBody& b, float timeLeft,
                      const Settings& settings);

}  // namespace plumb::physics
