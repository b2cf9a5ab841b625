#pragma once

#include <cstdint>
#include <limits>

#include "physics/geometry.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// Surface numbers from here on are given by the library.
inline constexpr std::uint32_t kOwnSurfaces = 1u << 28;

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
    /// All shapes of one number are one surface, on whatever bodies they are: events tell of what touches the
    /// surface, not of the seams that it passes. 0 is on its own; createChain() then numbers the chain.
    /// Numbers below kOwnSurfaces are the caller's.
    std::uint32_t surface = 0;
    /// Of a border inside something that only some meet: it does not meet those who meet shapes of these
    /// layers and mask, which they are stopped by before. 0 for all others.
    std::uint32_t frontLayers = 0;
    std::uint32_t frontMask = 0;
};

}  // namespace plumb::physics
