#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Looks at the entity's Transform, which is the middle of the view. The first enabled camera draws.
struct Camera {
    bool enabled = true;
    float zoom = 1.0f;           ///< ratio; 2 shows half as much, twice as large
    EntityId follow;             ///< empty: the camera stays where it is
    Vec2 offset;                 ///< px, from what it follows to the middle of the view
    Vec2 deadZone;               ///< px, size of the box in which the followed moves freely
    Vec2 lookAhead;              ///< s of the followed body's velocity to look ahead
    float smoothing = 0.0f;      ///< s to come most of the way; 0 is at once
    Rect limits;                 ///< px of the world that the view stays in; empty for none
    float previousZoom = 1.0f;   ///< ratio, one tick ago
    float shakeStrength = 0.0f;  ///< px, at the start of the shake
    float shakeSeconds = 0.0f;   ///< s, how long the shake takes
    float shakeTime = 0.0f;      ///< s since the shake began
    bool settled = false;        ///< has been at its target once; the first tick jumps there

    static void describe(TypeBuilder<Camera>& type) {
        type.name("Camera").doc("Looks at the entity's Transform; the first enabled camera draws.");
        type.field<&Camera::enabled>("enabled");
        type.field<&Camera::zoom>("zoom")
            .unit(Unit::Ratio)
            .range(0.01f, 100.0f)
            .doc("2 shows everything twice as large.");
        type.field<&Camera::follow>("follow").doc("The entity to keep in view.");
        type.field<&Camera::offset>("offset")
            .unit(Unit::Pixels)
            .doc("From what it follows to the middle of the view.");
        type.field<&Camera::deadZone>("deadZone")
            .unit(Unit::Pixels)
            .doc("Size of the box in which the followed moves freely.");
        type.field<&Camera::lookAhead>("lookAhead")
            .unit(Unit::Seconds)
            .doc("Of the followed body's velocity.");
        type.field<&Camera::smoothing>("smoothing")
            .unit(Unit::Seconds)
            .range(0.0f, 10.0f)
            .doc("0 follows at once.");
        type.field<&Camera::limits>("limits")
            .unit(Unit::Pixels)
            .doc("The view stays inside; empty for no limits.");
        type.field<&Camera::previousZoom>("previousZoom").unit(Unit::Ratio).transient();
        type.field<&Camera::shakeStrength>("shakeStrength").unit(Unit::Pixels).transient();
        type.field<&Camera::shakeSeconds>("shakeSeconds").unit(Unit::Seconds).transient();
        type.field<&Camera::shakeTime>("shakeTime").unit(Unit::Seconds).transient();
        type.field<&Camera::settled>("settled").transient();
    }
};

/// Shakes the view for a while. A stronger shake that is under way wins.
inline void shake(Camera& camera, float strength, float seconds) {
    const bool running = camera.shakeTime < camera.shakeSeconds;
    if (running && camera.shakeStrength * (1.0f - camera.shakeTime / camera.shakeSeconds) > strength) return;
    camera.shakeStrength = strength;
    camera.shakeSeconds = seconds;
    camera.shakeTime = 0.0f;
}

}  // namespace plumb
