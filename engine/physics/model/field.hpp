#pragma once

#include <cstdint>

#include "physics/model/body.hpp"

namespace plumb::physics {

/// The kinds of fields. Each has a row in effects/field_types.cpp.
enum class FieldKind : std::uint8_t {
    AreaGravity,  ///< gravity of its own in a region, along a direction or towards a point
    Wind,         ///< moving air: drag proportional to the square of the relative speed, with gusts
    Buoyancy,     ///< a fluid: lifts bodies and slows them down
    Attractor,    ///< attracts towards a point or a body, as a planet or a magnet does
    Explosion,    ///< a single impulse away from a point; the field is then removed
    Spring,       ///< Hooke's law between a body and a point or another body
    Count
};

/// Where a field acts. A body is in the region if its centre of mass is; Buoyancy uses the exact outline.
enum class RegionKind : std::uint8_t { Everywhere, Box, Circle, Count };

/// Everything that a new field needs. Members that a kind does not use are ignored.
struct FieldDefinition {
    FieldKind kind = FieldKind::AreaGravity;
    RegionKind region = RegionKind::Everywhere;
    bool replacesGravity = false;        ///< AreaGravity: the world's gravity does not act there
    bool linear = false;                 ///< Attractor: the acceleration is proportional to the distance
    std::uint32_t layers = 0xffffffffu;  ///< bits: acts on bodies that have a shape on one of these layers
    WorldPosition place{};  ///< m: centre of the region or of the attraction, fixed end of a spring; of a
                            ///< fluid Everywhere, a point on its surface
    Vec2 half{1.0f, 1.0f};  ///< m: half size of a Box
    float radius = 1.0f;    ///< m: of a Circle, and of Explosion
    Vec2 acceleration{};    ///< m/s2: of AreaGravity
    Vec2 velocity{};        ///< m/s: of Wind, and the current of a fluid
    float strength = 0.0f;  ///< AreaGravity: m/s2 towards `place`. Attractor: m3/s2, falling with the square
                            ///< of the distance, or 1/s2 if linear. Explosion: N s per metre of the shape's
                            ///< width at the centre, falling linearly to 0 at the radius. Spring: N/m
    float damping = 0.0f;   ///< Spring: N s/m
    float length = 0.0f;    ///< m: rest length of a Spring; softening length of an Attractor
    float density = 1.0f;   ///< kg/m2: of a fluid. Wind: kg/m2, half the density times the drag coefficient
    float linearDrag = 0.0f;       ///< 1/s: of a fluid, for the mass of the fluid that the body displaces
    float angularDrag = 0.0f;      ///< 1/s
    float gust = 0.0f;             ///< m/s: Wind: maximum deviation from the mean speed
    std::uint32_t gustSteps = 30;  ///< steps between gusts
    std::uint32_t seed = 1;        ///< seed of the gusts
    BodyId a{};                    ///< Spring: first end; Attractor: its centre, if given
    BodyId b{};                    ///< Spring: the other end, if given; `place` is then unused
    Vec2 anchorA{};                ///< m, in A's frame
    Vec2 anchorB{};                ///< m, in B's frame
};

/// A field of a world. In a free slot `definition.kind` has no meaning.
struct Field {
    FieldDefinition definition;
    std::uint32_t generation = 0;
    bool isAlive = false;
};

}  // namespace plumb::physics
