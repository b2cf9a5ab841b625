#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// State of a body at the time of an impact.
struct ImpactBody {
    BodyPose pose;
    BodyMotion motion;
    BodyMass mass;  ///< static or kinematic: inverse mass 0
};

/// Applies the impulses of an impact, with friction and restitution, to the two bodies of a contact, and
/// stores them in the contact. Never adds energy, for any outlines and masses.
/// @param contact  contact with its points at these poses
/// @param left  s: rest of the step after the impact. A second point that is still separated may close
///         its gap in this time, so that a body that lands nearly flat lands on both points.
void exchangeImpulses(Contact& contact, ImpactBody& a, ImpactBody& b, float left, const Settings& settings);

}  // namespace plumb::physics
