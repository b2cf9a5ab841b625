#pragma once

#include "math/vec2.hpp"
#include "reflect/entity_id.hpp"

namespace plumb {

/// Two solid colliders that touch. Emitted by the physics step, at most once per pair and tick. ContactStayed
/// is not emitted while both bodies sleep.
struct Contact {
    EntityId a;
    EntityId b;
    Vec2 normal;           ///< length 1, from a towards b
    Vec2 point;            ///< px
    float impulse = 0.0f;  ///< kg px/s, normal impulse
};
struct ContactBegan : Contact {};
struct ContactStayed : Contact {};
struct ContactEnded : Contact {};

/// An overlap of a trigger with another collider. Two overlapping triggers emit one event each.
struct TriggerOverlap {
    EntityId trigger;
    EntityId other;
};
struct TriggerEntered : TriggerOverlap {};
struct TriggerStayed : TriggerOverlap {};
struct TriggerLeft : TriggerOverlap {};

/// A joint broke because its force exceeded breakForce. Its component has been removed.
struct JointBroke {
    EntityId entity;  ///< entity that had the joint component
    EntityId other;   ///< entity of the other body; empty: the world
};

}  // namespace plumb
