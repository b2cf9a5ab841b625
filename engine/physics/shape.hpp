#pragma once

#include <cstdint>
#include <limits>

#include "physics/geometry.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// What a shape is made of and whom it meets; its outline is a Geometry.
struct ShapeDefinition {
    float density = 1.0f;               ///< kg/m2; 0 adds no mass
    float friction = 0.6f;              ///< Coulomb coefficient; of two, the square root of the product
    float bounciness = 0.0f;            ///< ratio of speed kept by a bounce; of two, the larger
    float rollingResistance = 0.0f;     ///< ratio to the radius; of two, the larger
    float surfaceSpeed = 0.0f;          ///< m/s along the surface, as a conveyor belt
    std::uint32_t layers = 1;           ///< bits: what it is
    std::uint32_t mask = 0xffffffffu;   ///< bits: what it meets; both must agree
    std::int32_t group = 0;             ///< two of the same group: above 0 always meet, below 0 never
    bool isTrigger = false;             ///< reports who overlaps it, stops nobody
    bool oneWay = false;                ///< stops only what comes against `oneWayDirection`
    Vec2 oneWayDirection{0.0f, -1.0f};  ///< in the body's frame: out of the solid side
    bool reportsContacts = true;        ///< collisions of it are events
    std::uint64_t user = 0;             ///< the owner's own number for it, repeated in events
};

}  // namespace plumb::physics
