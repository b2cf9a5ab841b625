#pragma once

#include <cstdint>

#include "physics/body.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// The kinds of fields. Each has one file in effects/ and a row in effects/field_types.cpp.
enum class FieldKind : std::uint8_t {
    AreaGravity,  ///< another gravity in a region, along a direction or towards a point
    Wind,         ///< air that moves: drags by the square of the speed, in gusts
    Buoyancy,     ///< a fluid: lifts what is in it and slows it down
    Attractor,    ///< pulls towards a point or a body, as a planet or a magnet
    Explosion,    ///< pushes once, away from a point, and is gone
    Spring,       ///< Hooke's law between a body and a point or another body
    Count
};

/// Where a field acts. Bodies count by their centre of mass; a fluid looks at the very outline.
enum class RegionKind : std::uint8_t { Everywhere, Box, Circle, Count };

/// Everything a new field needs. Unused members of a kind are ignored.
struct FieldDefinition {
    FieldKind kind = FieldKind::AreaGravity;
    RegionKind region = RegionKind::Everywhere;
    bool replacesGravity = false;        ///< of AreaGravity: the world's own does not act there
    bool linear = false;                 ///< of Attractor: the pull grows with the distance
    std::uint32_t layers = 0xffffffffu;  ///< bits: acts on bodies with a shape on one of these
    Place place{};          ///< m: middle of the region, centre of a pull, fixed end of a spring;
                            ///< of a fluid Everywhere a point of its surface
    Vec2 half{1.0f, 1.0f};  ///< m: of a Box
    float radius = 1.0f;    ///< m: of a Circle, and of Explosion
    Vec2 acceleration{};    ///< m/s2: of AreaGravity
    Vec2 velocity{};        ///< m/s: of Wind and the current of a fluid
    float strength = 0.0f;  ///< AreaGravity: m/s2 towards `place`. Attractor: m3/s2 by the inverse square of
                            ///< the distance, or 1/s2 if linear. Explosion: N s for each metre of width at
                            ///< its centre, none at its radius. Spring: N/m
    float damping = 0.0f;   ///< Spring: N s/m
    float length = 0.0f;    ///< m: Spring: at rest. Attractor: softens the pull nearer than this
    float density = 1.0f;   ///< kg/m2: of a fluid. Wind: kg/m2, half its density times the drag coefficient
    float linearDrag = 0.0f;       ///< 1/s: of a fluid, for its own mass that is displaced
    float angularDrag = 0.0f;      ///< 1/s
    float gust = 0.0f;             ///< m/s: Wind: at most so much more or less
    std::uint32_t gustSteps = 30;  ///< steps from gust to gust
    std::uint32_t seed = 1;        ///< of the gusts
    BodyId a{};                    ///< of Spring; of Attractor: its centre, if given
    BodyId b{};                    ///< of Spring: the other end, if given; `place` is not used then
    Vec2 anchorA{};                ///< m, in A's frame
    Vec2 anchorB{};                ///< m, in B's frame
};

/// A field of a world. `definition.kind` of a free place means nothing.
struct Field {
    FieldDefinition definition;
    std::uint32_t generation = 0;
    bool isAlive = false;
};

}  // namespace plumb::physics
