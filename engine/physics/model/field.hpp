#pragma once

#include <cstdint>

#include "physics/model/body.hpp"

namespace plumb::physics {

/// The kinds of fields. Each has a row in effects/field_types.cpp.
enum class FieldKind : std::uint8_t {
    AreaGravity,  ///< gravity in a region, along a direction or towards a point
    Wind,         ///< moving air: drag proportional to the square of the relative speed, with gusts
    Buoyancy,     ///< a fluid: lifts bodies and slows them down
    Attractor,    ///< attraction to a point or a body, as by a planet or a magnet
    Explosion,    ///< a single impulse away from a point; the field is then removed
    Spring,       ///< Hooke's law between a body and a point or another body
    Count
};

/// Shape of a field's region. A field acts on bodies whose centre of mass is inside; Buoyancy uses outlines.
enum class RegionKind : std::uint8_t { Everywhere, Box, Circle, Count };

/// Properties of a new field. Members that a kind does not use are ignored.
struct FieldDefinition {
    FieldKind kind = FieldKind::AreaGravity;
    RegionKind region = RegionKind::Everywhere;
    bool replacesGravity = false;        ///< AreaGravity: no world gravity in the region
    bool linear = false;                 ///< Attractor: the acceleration is proportional to the distance
    std::uint32_t layers = 0xffffffffu;  ///< bits: acts on bodies with a shape on one of these
    WorldPosition place{};  ///< m: centre of the region or of the attraction; fixed end of a spring; for a
                            ///< fluid Everywhere: a point on its surface
    Vec2 half{1.0f, 1.0f};  ///< m: half size of a Box
    float radius = 1.0f;    ///< m: radius of a Circle or an Explosion
    Vec2 acceleration{};    ///< m/s2: gravity of AreaGravity
    Vec2 velocity{};        ///< m/s: velocity of the air of Wind, or of a fluid
    float strength = 0.0f;  ///< AreaGravity: m/s2 towards `place`. Attractor: m3/s2, inverse-square law, or
                            ///< 1/s2 if linear. Explosion: N s per metre of the shape's width at the centre,
                            ///< decreasing linearly to 0 at the radius. Spring: N/m
    float damping = 0.0f;   ///< Spring: N s/m
    float length = 0.0f;    ///< m: rest length of a Spring; softening length of an Attractor
    float density = 1.0f;   ///< kg/m2, of a fluid. Wind: half the density times the drag coefficient
    float linearDrag = 0.0f;       ///< 1/s, in a fluid: relative to the mass of the displaced fluid
    float angularDrag = 0.0f;      ///< 1/s
    float gust = 0.0f;             ///< m/s, Wind: maximum deviation from `velocity`
    std::uint32_t gustSteps = 30;  ///< steps between gusts
    std::uint32_t seed = 1;        ///< seed of the gusts
    BodyId a{};                    ///< Spring: body at the first end; Attractor: body at its centre, if set
    BodyId b{};                    ///< Spring: body at the other end, if set instead of `place`
    Vec2 anchorA{};                ///< m, in A's frame
    Vec2 anchorB{};                ///< m, in B's frame
};

/// A field of a world. In a free slot isAlive is false and the definition has no meaning.
struct Field {
    FieldDefinition definition;
    std::uint32_t generation = 0;
    bool isAlive = false;
};

}  // namespace plumb::physics
