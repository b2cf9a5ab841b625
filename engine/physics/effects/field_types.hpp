#pragma once

#include <string_view>

#include "physics/world.hpp"

namespace plumb::physics {

/// How a body moves at some moment of a step.
struct BodyState {
    Place centre;  ///< m
    Rot rotation;
    Vec2 velocity;                 ///< m/s
    float angularVelocity = 0.0f;  ///< rad/s
};

struct Acceleration {
    Vec2 linear;           ///< m/s2
    float angular = 0.0f;  ///< rad/s2

    Acceleration& operator+=(const Acceleration& more) {
        linear += more.linear;
        angular += more.angular;
        return *this;
    }
};

/// What fields may look at besides the body.
struct FieldView {
    const World& world;
    float h;  ///< s: the step of the integrator; a drag never takes more than all of a speed in it
    /// Where another body is now; of bodies that do not fly with this one, a guess from the step's start.
    BodyState (*stateOf)(const FieldView& view, std::uint32_t body) = nullptr;
    const void* flight = nullptr;  ///< of stateOf
    float elapsed = 0.0f;          ///< s since the start of the step
    bool withSteady = true;        ///< false leaves out what isConstant()
};

/// What the kinds of fields do differently.
struct FieldType {
    std::string_view name;
    Effect effect;
    /// What the field does to a body in a state; null where it is no acceleration.
    Acceleration (*acceleration)(const FieldView& view, const FieldDefinition& field, std::uint32_t body,
                                 const BodyState& state) = nullptr;
};

const FieldType& fieldTypeOf(FieldKind kind);

/// Whether a field acts on a body where it is now.
[[nodiscard]] bool actsOn(const World& world, const FieldDefinition& field, std::uint32_t body);
/// Whether a place is in the region of a field, whatever is there.
[[nodiscard]] bool isInRegion(const FieldDefinition& field, Place place);
/// m/s: how the air of a Wind moves in a step, gusts included.
[[nodiscard]] Vec2 airOf(const FieldDefinition& field, std::uint64_t step);
/// Whether it does the same to a body wherever it is and however it moves, so that the way is known exactly.
[[nodiscard]] bool isConstant(const FieldDefinition& field);

// One line per kind, each in a file of its name.

Acceleration areaGravity(const FieldView&, const FieldDefinition&, std::uint32_t, const BodyState&);
Acceleration wind(const FieldView&, const FieldDefinition&, std::uint32_t, const BodyState&);
Acceleration buoyancy(const FieldView&, const FieldDefinition&, std::uint32_t, const BodyState&);
Acceleration attractor(const FieldView&, const FieldDefinition&, std::uint32_t, const BodyState&);
Acceleration spring(const FieldView&, const FieldDefinition&, std::uint32_t, const BodyState&);

/// m: how wide a shape looks from the side, across a direction of length 1 in the shape's own frame.
[[nodiscard]] float widthAcross(const Geometry& geometry, std::span<const Corner> corners, Vec2 direction);
/// m: the same of a whole body, for a direction in the world. Shapes behind each other count once each,
/// triggers not at all.
[[nodiscard]] float widthAcross(const World& world, std::uint32_t body, Rot rotation, Vec2 direction);

}  // namespace plumb::physics
