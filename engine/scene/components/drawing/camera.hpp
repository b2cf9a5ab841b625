#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// A camera whose view is centered on the entity's Transform. The first enabled camera of a scene is used.
struct Camera {
    bool enabled = true;
    float zoom = 1.0f;  ///< ratio; 2 draws everything twice as large
    EntityId follow;    ///< entity to follow; empty: the camera does not move
    Vec2 offset;        ///< px, from the followed entity to the center of the view
    Vec2 deadZone;   ///< px, size of the box in which the followed entity can move without moving the camera
    Vec2 lookAhead;  ///< s: the view is ahead of the followed body by its velocity times this
    float smoothing = 0.0f;      ///< s in which it covers 95 % of the distance to its target; 0: at once
    Rect limits;                 ///< px, world: rectangle that the view stays inside; empty: no limits
    float previousZoom = 1.0f;   ///< zoom one tick ago (ratio)
    float shakeStrength = 0.0f;  ///< px, amplitude at the start of the shake
    float shakeSeconds = 0.0f;   ///< s, duration of the shake
    float shakeTime = 0.0f;      ///< s since the shake began
    bool settled = false;        ///< false until the first tick, in which the camera jumps to its target

    static void describe(TypeBuilder<Camera>& type) {
        type.name("Camera").doc(
            "A camera centered on the entity's Transform; the first enabled camera is used.");
        type.field<&Camera::enabled>("enabled");
        type.field<&Camera::zoom>("zoom")
            .unit(Unit::Ratio)
            .range(0.01f, 100.0f)
            .doc("Zoom as a ratio; 2 draws everything twice as large.");
        type.field<&Camera::follow>("follow").doc("Entity that the camera follows.");
        type.field<&Camera::offset>("offset")
            .unit(Unit::Pixels)
            .doc("Vector from the followed entity to the center of the view, px.");
        type.field<&Camera::deadZone>("deadZone")
            .unit(Unit::Pixels)
            .doc("Size of the box in which the followed entity can move without moving the camera, px.");
        type.field<&Camera::lookAhead>("lookAhead")
            .unit(Unit::Seconds)
            .doc("Look-ahead time, s: the view is ahead of the followed body by its velocity times this.");
        type.field<&Camera::smoothing>("smoothing")
            .unit(Unit::Seconds)
            .range(0.0f, 10.0f)
            .doc("Time in which the camera covers 95 % of the distance to its target, s; 0: at once.");
        type.field<&Camera::limits>("limits")
            .unit(Unit::Pixels)
            .doc("World rectangle that the view stays inside, px; empty for no limits.");
        type.field<&Camera::previousZoom>("previousZoom").unit(Unit::Ratio).transient();
        type.field<&Camera::shakeStrength>("shakeStrength").unit(Unit::Pixels).transient();
        type.field<&Camera::shakeSeconds>("shakeSeconds").unit(Unit::Seconds).transient();
        type.field<&Camera::shakeTime>("shakeTime").unit(Unit::Seconds).transient();
        type.field<&Camera::settled>("settled").transient();
    }
};

/// Starts a shake of the view. Does nothing while the current shake is still stronger.
/// @param strength  px, amplitude at the start
/// @param seconds   s, duration
inline void shake(Camera& camera, float strength, float seconds) {
    const bool running = camera.shakeTime < camera.shakeSeconds;
    if (running && camera.shakeStrength * (1.0f - camera.shakeTime / camera.shakeSeconds) > strength) return;
    camera.shakeStrength = strength;
    camera.shakeSeconds = seconds;
    camera.shakeTime = 0.0f;
}

}  // namespace plumb
