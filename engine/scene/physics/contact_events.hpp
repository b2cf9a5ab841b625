#pragma once

#include "math/vec2.hpp"
#include "reflect/entity_id.hpp"

namespace plumb {

/// Two solid colliders that touch. Emitted by the physics step, each pair once a tick. While both rest
/// asleep, no event says that they stay.
struct Contact {
    EntityId a;
    EntityId b;
    Vec2 normal;           ///< length 1, from a towards b
    Vec2 point;            ///< px
    float impulse = 0.0f;  ///< kg px/s that kept them apart
};
struct ContactBegan : Contact {};
struct ContactStayed : Contact {};
struct ContactEnded : Contact {};

/// Something overlaps a trigger. When both are triggers, each gets its own event.
struct TriggerOverlap {
    EntityId trigger;
    EntityId other;
};
struct TriggerEntered : TriggerOverlap {};
struct TriggerStayed : TriggerOverlap {};
struct TriggerLeft : TriggerOverlap {};

/// A joint was pulled harder than its breakForce. Its component is gone.
struct JointBroke {
    EntityId entity;  ///< whose joint it was
    EntityId other;
};

}  // namespace plumb
