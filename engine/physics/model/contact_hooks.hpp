#pragma once

#include "physics/model/contact.hpp"

namespace plumb::physics {

struct World;

/// Callbacks by which the owner of a world decides about contacts. They are called in a fixed order, by the
/// thread that steps, and must give the same answer for the same world; otherwise steps are not reproducible.
/// They must not change the world: functions that would do so refuse to.
struct ContactHooks {
    void* context = nullptr;  ///< passed to the callbacks
    /// May these two shapes collide? Called when their bounds begin to overlap; if it returned false, again
    /// when one of them has moved on.
    bool (*filter)(void* context, const World& world, ShapeId a, ShapeId b) = nullptr;
    /// Does this contact exert forces in this step? Called in every step while the shapes touch.
    /// contactPoints() has its points.
    bool (*preSolve)(void* context, const World& world, const Contact& contact) = nullptr;
    /// Friction and bounciness of a contact, instead of those of ShapeDefinition. Called in every step while
    /// the shapes touch. Results out of range are clamped, NaN counts as 0.
    float (*friction)(void* context, const World& world, const Contact& contact) = nullptr;
    float (*bounciness)(void* context, const World& world, const Contact& contact) = nullptr;
};

}  // namespace plumb::physics
