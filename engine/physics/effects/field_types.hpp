#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// State of a body at some time within a step.
struct BodyState {
    WorldPosition centre;  ///< m
    Rot rotation;
    Vec2 velocity;                 ///< m/s
    float angularVelocity = 0.0f;  ///< rad/s
};

/// Integrators use it for displacements (m, rad) and velocities, too.
struct Acceleration {
    Vec2 linear;           ///< m/s2
    float angular = 0.0f;  ///< rad/s2
};
inline Acceleration operator+(const Acceleration& a, const Acceleration& b) {
    return {a.linear + b.linear, a.angular + b.angular};
}
inline Acceleration operator*(float s, const Acceleration& a) { return {s * a.linear, s * a.angular}; }
inline Acceleration operator-(const Acceleration& a, const Acceleration& b) { return a + -1.0f * b; }
inline Acceleration& operator+=(Acceleration& a, const Acceleration& b) { return a = a + b; }

/// What a field may read besides the state of the body that it acts on.
struct FieldView {
    const World& world;
    float h;                                   ///< s: step of the integrator
    std::span<const float> springScales = {};  ///< by field, see SmoothForces
    /// Current state of another body. One that is not integrated with this is where stateAfter() expects it.
    BodyState (*stateOf)(const FieldView& view, std::uint32_t body) = nullptr;
    const void* flight = nullptr;  ///< context of stateOf
    float elapsed = 0.0f;          ///< s since the start of the step
};

/// What a field does to a body in a state.
struct FieldForce {
    Acceleration acceleration;
    /// h c + (h w)^2 / 2 of its damping (c, 1/s) and of the oscillation that it causes (w, rad/s), an upper
    /// bound: an explicit step can follow up to 1, and becomes unstable from 2.
    float stiffness = 0.0f;
    float angularDrag = 0.0f;  ///< 1/s

    FieldForce& operator+=(const FieldForce& more) {
        acceleration += more.acceleration;
        stiffness += more.stiffness;
        angularDrag += more.angularDrag;
        return *this;
    }
};

/// One kind of field: a row of the table in field_types.cpp.
struct FieldType {
    Effect effect;
    /// Null if it is not a smooth force (explosions).
    FieldForce (*force)(const FieldView& view, std::uint32_t field, std::uint32_t body,
                        const BodyState& state) = nullptr;
};

const FieldType& fieldTypeOf(FieldKind kind);

/// True if a field acts on a body at its current position.
[[nodiscard]] bool actsOn(const World& world, const FieldDefinition& field, std::uint32_t body);
/// m: center of the region of a field. That of an Attractor moves with its body.
[[nodiscard]] WorldPosition centreOf(const World& world, const FieldDefinition& field);
/// The shape of the region of a field; that of an explosion is always a circle.
constexpr RegionKind regionOf(const FieldDefinition& field) {
    return field.kind == FieldKind::Explosion ? RegionKind::Circle : field.region;
}
[[nodiscard]] bool isInRegion(const FieldDefinition& field, WorldPosition place);
/// m/s: velocity of the air of a Wind in a given step, gusts included.
[[nodiscard]] Vec2 airOf(const FieldDefinition& field, std::uint64_t step);
/// True if its acceleration depends on no position or velocity: trajectories have a closed form.
[[nodiscard]] bool isConstant(const FieldDefinition& field);

/// True if a body has a shape on one of these layers, or if they are all.
[[nodiscard]] bool isOnLayers(const World& world, std::uint32_t layers, std::uint32_t body);

/// Acceleration of a body in a state by those of a list of fields that are not constant, m/s2 and rad/s2. The
/// only evaluation of smooth forces: for all integrators, and for bodies that touch something. If the fields
/// together are too stiff for the step, the body reacts as if it was heavier: what it comes to rest at and
/// its terminal velocity remain.
/// @param other  all that acts on the body besides these fields
Acceleration accelerationAt(const FieldView& view, std::span<const std::uint32_t> fields, std::uint32_t body,
                            const BodyState& state, const Acceleration& other);
/// State of a body some time (s) after the start of the step, if nothing acts on it.
BodyState stateAfter(const World& world, std::uint32_t body, float elapsed);

FieldForce buoyancy(const FieldView&, std::uint32_t, std::uint32_t, const BodyState&);
/// FieldForce::stiffness of a spring for one of its ends.
[[nodiscard]] float springStiffness(const World& world, const FieldDefinition& field, std::uint32_t body,
                                    float h);

/// m: width of a shape across a unit direction in the shape's frame.
[[nodiscard]] float widthAcross(const Geometry& geometry, std::span<const Corner> corners, Vec2 direction);
/// m: width of a whole body across a direction in the world: the sum over its solid shapes.
[[nodiscard]] float widthAcross(const World& world, std::uint32_t body, Rot rotation, Vec2 direction);

/// A body in a field, without contacts and joints: integrated by Settings::integrator.
struct Flyer {
    std::uint32_t slot = 0;
    std::uint32_t body = 0;
    Acceleration steady;    ///< the part that does not depend on the state
    bool isSteady = false;  ///< all of it is steady: the trajectory has a closed form
    float linearDrag = 0.0f;
    float angularDrag = 0.0f;
    BodyState now;
    float turned = 0.0f;  ///< rad since the start of the step
    BodyState trial;      ///< state in which its forces are evaluated
    Acceleration at[4];   ///< accelerations of the stages, see each integrator
};

/// Ratio by which drag reduces a constant acceleration over a substep.
struct DriveScale {
    float linear = 1.0f;
    float angular = 1.0f;
};

/// How a body is integrated.
enum class FieldMotion : std::uint8_t {
    Steady,  ///< by the solver; constant accelerations alone
    Driven,  ///< by the solver, as contacts or joints hold it: its fields are evaluated before each substep
    Free,    ///< by Settings::integrator
};

/// A body in a field that contacts or joints hold: the solver integrates it.
struct Driven {
    std::uint32_t slot = 0;
    std::uint32_t body = 0;
    Acceleration steady;  ///< as of a Flyer
    DriveScale scale;
    Acceleration moved;  ///< m, rad: displacement before the current substep
    float work = 0.0f;   ///< J: of all accelerations so far
};

/// Which fields act on which bodies in a step, and which bodies are integrated freely.
struct SmoothForces {
    struct Pull {
        std::uint32_t slot;
        std::uint32_t field;
    };
    std::vector<Pull> pulls;
    std::vector<std::uint32_t> begins;  ///< by slot: start of its list in `fields`; one more entry at the end
    std::vector<std::uint32_t> fields;
    /// By field: ratio by which a spring is softened, as its ends hang on more, or stiffer, springs than a
    /// step can follow. One for both ends, so that momentum is kept.
    std::vector<float> springScales;
    std::vector<FieldMotion> motions;  ///< by slot; empty in a step without fields
    std::vector<Flyer> flyers;         ///< in order of their slots
    std::vector<Driven> driven;        ///< in order of their slots
    /// By slot, J: work on a driven body beyond that of the accelerations of the last substep.
    std::vector<float> works;
    std::vector<std::int32_t> flyerOf;  ///< by body: index in `flyers`, or -1

    [[nodiscard]] std::span<const std::uint32_t> fieldsOf(std::size_t slot) const {
        return std::span{fields}.subspan(begins[slot], begins[slot + 1] - begins[slot]);
    }
};

// Finds the fields that may act on a body by the boxes in which they act: many small fields cost no more than
// what they overlap. Fields without bounds may act on all. Springs know their bodies.

/// Updates Workspace::fieldBoxes to fields that were changed, and bodies of attractors that moved.
void updateFieldBoxes(const World& world, Workspace& work);

/// Fields that may act on a body, ascending, until the next call: at least those for which actsOn() holds.
/// @param kinds  bits, 1 << FieldKind: those to search for; others may be among the result
std::span<const std::uint32_t> fieldsNear(const World& world, Workspace& work, std::uint32_t body,
                                          std::uint32_t kinds);

/// Calls act(body, field) for all awake bodies and the fields that act on them; `kinds` as above.
template <class Act>
void forFieldsOnBodies(const World& world, Workspace& work, std::uint32_t kinds, Act&& act) {
    updateFieldBoxes(world, work);
    for (const std::uint32_t body : world.awake) {
        if (!isDynamic(world, body)) continue;
        for (const std::uint32_t f : fieldsNear(world, work, body, kinds)) {
            if (actsOn(world, world.fields.all[f].definition, body)) act(body, f);
        }
    }
}

}  // namespace plumb::physics
