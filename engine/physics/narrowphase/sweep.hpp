#pragma once

#include <optional>

#include "physics/shapes/convex.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// The way of a body through a step: straight and even. Parts of it are 0 at the start and 1 at the end.
struct Sweep {
    Place start;        ///< m, of the centre of mass
    Vec2 way;           ///< m
    Rot rotation;       ///< at the start
    float turn = 0.0f;  ///< rad; may be several full turns
    Vec2 localCentre;   ///< m: the centre of mass in the frame of the shapes
    float end = 1.0f;   ///< it stops at this part

    [[nodiscard]] BodyPose at(float part) const;
};

/// A way that leads nowhere.
Sweep resting(const BodyPose& pose);

/// An outline that is taken along.
struct SweptOutline {
    const Convex& outline;
    const Sweep& sweep;
};

struct Impact {
    float part = 0.0f;  ///< of the way
    Vec2 normal;        ///< world, length 1, from the first to the second
    Place point;        ///< m, on the surface of the first
};

/// When two outlines come as near as `gap`; 0 when they begin like that. Never too late: what cannot be found
/// exactly in reasonable time is found early.
/// @param gap     m, not negative
/// @param latest  part of the way after which nobody asks
/// Source: B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, 2.3 (conservative
///         advancement)
std::optional<Impact> firstImpact(const SweptOutline& a, const SweptOutline& b, float gap,
                                  float latest = 1.0f);

}  // namespace plumb::physics
