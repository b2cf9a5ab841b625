#pragma once

#include <cstdint>
#include <limits>

#include "physics/ids.hpp"
#include "physics/model/geometry.hpp"

namespace plumb::physics {

/// Surface numbers from this one on are reserved for the library.
inline constexpr std::uint32_t kOwnSurfaces = 1u << 28;

/// Material and collision filter of a shape; its outline is a Geometry.
struct ShapeDefinition {
    float density = 1.0f;            ///< kg/m2; 0 adds no mass
    float friction = 0.6f;           ///< Coulomb coefficient; a contact uses the geometric mean of the two
    float bounciness = 0.0f;         ///< coefficient of restitution; a contact uses the larger of the two
    float rollingResistance = 0.0f;  ///< ratio to the radius; a contact uses the larger of the two
    /// m/s along the surface, as of a conveyor belt: positive moves what touches it along its outward normal
    /// rotated from x towards y. So with y down what lies on it goes to the right, with y up to the left.
    float surfaceSpeed = 0.0f;
    std::uint32_t layers = 1;          ///< bits: the layers that it is on
    std::uint32_t mask = 0xffffffffu;  ///< bits: the layers that it collides with; both shapes must agree
    std::int32_t group = 0;  ///< two shapes of the same group collide always (above 0) or never (below 0)
    /// A sensor: it reports overlaps at the end of a step, wakes what it comes to, and exerts no forces.
    bool isTrigger = false;
    bool oneWay = false;                ///< stops only bodies from the side that `oneWayDirection` points to
    Vec2 oneWayDirection{0.0f, -1.0f};  ///< outward normal of the solid side, in the body's frame
    bool reportsContacts = true;        ///< its contacts produce events
    std::uint64_t user = 0;             ///< the owner's own number for it, returned in events
    /// Shapes with the same number form one surface, also across bodies: events report when a body begins and
    /// ends to touch the surface, not each seam between its shapes. 0: the shape is on its own; createChain()
    /// then assigns a number to the chain. Numbers below kOwnSurfaces are the caller's.
    std::uint32_t surface = 0;
    /// For an inner border, as between two kinds of terrain: a shape that collides with these layers and this
    /// mask ignores the border, because what lies in front of it stops that shape first. 0: not an inner
    /// border.
    std::uint32_t frontLayers = 0;
    std::uint32_t frontMask = 0;

    friend constexpr bool operator==(const ShapeDefinition&, const ShapeDefinition&) = default;
};

}  // namespace plumb::physics
