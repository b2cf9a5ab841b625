#pragma once

#include <limits>

#include "math/vec2.hpp"
#include "physics/model/joint.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// The bodies, anchors and limits that all joint components have. The joint belongs to this entity's body.
struct JointLink {
    EntityId other;          ///< entity of the other body; empty: the world
    Vec2 anchor;             ///< px from the entity's Transform, rotated with it
    Vec2 otherAnchor;        ///< px from the other entity's Transform, rotated with it, or px in the world
    bool autoAnchor = true;  ///< ignore `otherAnchor`: use the position of `anchor` when the joint is created
    float breakForce = 0.0f;  ///< kg px/s^2: a larger force breaks and removes the joint; 0: never
    bool collide = false;     ///< the two bodies collide with each other
    int quality = -1;         ///< 2^quality substeps for the joint and its island; -1: the scene's quality
};

template <class T>
void describeLink(TypeBuilder<T>& type) {
    type.template field<&T::other>("other").doc("Entity of the other body; none connects to the world.");
    type.template field<&T::anchor>("anchor")
        .unit(Unit::Pixels)
        .doc("Anchor on this body, px from its Transform.");
    type.template field<&T::otherAnchor>("otherAnchor")
        .unit(Unit::Pixels)
        .shownIf("autoAnchor", 0)
        .doc("Anchor on the other body, px from its Transform, or px in the world.");
    type.template field<&T::autoAnchor>("autoAnchor")
        .doc("Places the anchor on the other body where this body's anchor is at the start.");
    type.template field<&T::breakForce>("breakForce")
        .range(0.0f, 1e12f)
        .doc("Force above which the joint breaks, kg px/s2; 0: never.");
    type.template field<&T::collide>("collide").doc("The two bodies collide with each other.");
    type.template field<&T::quality>("quality")
        .range(-1.0f, 6.0f)
        .doc(
            "Quality: 2^quality substeps for this joint and the bodies connected with it; -1: the scene's "
            "quality.");
}

/// Spring of a joint, by its frequency and damping.
struct JointStiffness {
    float hertz = 0.0f;         ///< frequency, Hz; 0: no spring
    float dampingRatio = 0.5f;  ///< 1: critical damping, no oscillation
};

template <class T>
void describeStiffness(TypeBuilder<T>& type) {
    type.template field<&T::hertz>("hertz")
        .range(0.0f, 1000.0f)
        .doc("Frequency of the spring, Hz; 0: no spring.");
    type.template field<&T::dampingRatio>("dampingRatio")
        .unit(Unit::Ratio)
        .range(0.0f, 100.0f)
        .doc("Damping ratio of the spring; 1 is critical damping, without oscillation.");
}

/// Converts the limit of a component to that of the physics: `force * scale`, or infinity for 0 (unlimited).
inline float forceLimit(float force, float scale) {
    return force > 0.0f ? force * scale : std::numeric_limits<float>::infinity();
}

}  // namespace plumb
