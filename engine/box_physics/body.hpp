#pragma once

#include <cstdint>

#include "box_physics/shape.hpp"

namespace plumb::box_physics {

/// Names a body: its place, and which user of that place it is, so that an old name never means a new body.
/// The default names nobody.
struct BodyId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;  ///< 0 names nobody

    explicit constexpr operator bool() const { return generation != 0; }
    friend constexpr bool operator==(BodyId, BodyId) = default;
};

/// Who moves a body: nobody, its owner, or forces and contacts. `None` marks a free place.
enum class BodyKind : std::uint8_t { None, Static, Kinematic, Dynamic };

/// Everything a new body needs.
struct BodyDefinition {
    BodyKind kind = BodyKind::Dynamic;
    Shape shape;
    Vec2 position;                     ///< m
    Vec2 velocity;                     ///< m/s
    Vec2 acceleration;                 ///< m/s2, added to gravity
    float mass = 1.0f;                 ///< kg, above 0; of dynamic bodies
    float gravityScale = 1.0f;         ///< ratio; 0 floats
    float friction = kTakesOther;      ///< coefficient; negative takes the other body's
    float bounciness = 0.0f;           ///< ratio 0..1 of the speed kept by a bounce; the larger of two counts
    std::uint32_t layers = 1;          ///< bits: what it is
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it meets; both bodies must agree
    bool isTrigger = false;            ///< reports who overlaps, stops nobody
    bool oneWay = false;               ///< stops only what comes from above (against gravity)
    std::uint64_t user = 0;            ///< the owner's own number for it, repeated in events

    static constexpr float kTakesOther = -1.0f;
};

}  // namespace plumb::box_physics
