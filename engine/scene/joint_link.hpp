#pragma once

#include <limits>

#include "math/vec2.hpp"
#include "physics/model/joint.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// What ties an entity's body to another one: the same for all joints.
struct JointLink {
    EntityId other;           ///< whose body; empty ties it to the world
    Vec2 anchor;              ///< px from the entity's Transform, turned with it
    Vec2 otherAnchor;         ///< px from the other's Transform, or in the world
    bool autoAnchor = true;   ///< the other's anchor is where `anchor` is when the joint is made
    float breakForce = 0.0f;  ///< kg px/s^2: pulled harder it breaks and is removed; 0 never breaks
    bool collide = false;     ///< the two bodies still collide
    int quality = -1;  ///< 2^quality substeps for it and what hangs together with it; -1 is the scene's
};

template <class T>
void describeLink(TypeBuilder<T>& type) {
    type.template field<&T::other>("other").doc("Whose body; none ties it to the world.");
    type.template field<&T::anchor>("anchor").unit(Unit::Pixels).doc("From the entity's Transform.");
    type.template field<&T::otherAnchor>("otherAnchor")
        .unit(Unit::Pixels)
        .shownIf("autoAnchor", 0)
        .doc("From the other's Transform, or in the world.");
    type.template field<&T::autoAnchor>("autoAnchor")
        .doc("The other's anchor is where this one is at the start.");
    type.template field<&T::breakForce>("breakForce")
        .range(0.0f, 1e12f)
        .doc("kg px/s2: pulled harder it breaks; 0 never breaks.");
    type.template field<&T::collide>("collide").doc("The two bodies still collide.");
    type.template field<&T::quality>("quality")
        .range(-1.0f, 6.0f)
        .doc("2^quality substeps for it and what hangs together with it; -1 is the scene's.");
}

/// A spring: how fast it swings, and how soon it comes to rest.
struct JointStiffness {
    float hertz = 0.0f;         ///< 1/s; 0 is no spring
    float dampingRatio = 0.5f;  ///< 1 comes to rest without swinging
};

template <class T>
void describeStiffness(TypeBuilder<T>& type) {
    type.template field<&T::hertz>("hertz")
        .range(0.0f, 1000.0f)
        .doc("1/s: swings of its spring; 0 for none.");
    type.template field<&T::dampingRatio>("dampingRatio")
        .unit(Unit::Ratio)
        .range(0.0f, 100.0f)
        .doc("1 comes to rest without swinging.");
}

/// An unlimited force is written as 0.
inline float forceOrEndless(float force, float scale) {
    return force > 0.0f ? force * scale : std::numeric_limits<float>::infinity();
}

}  // namespace plumb
