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

/// An acceleration; integrators use the type for displacements (m, rad) and velocities, too.
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

/// Input of FieldType::force besides the state of the body on which the field acts.
struct FieldView {
    const World& world;
    float h;                                   ///< s: step length of the integrator
    std::span<const float> springScales = {};  ///< indexed by field, see SmoothForces::springScales
    /// Returns the current state of another body: that of the integrator, or for a body that is not
    /// integrated together with this one, stateAfter().
    BodyState (*stateOf)(const FieldView& view, std::uint32_t body) = nullptr;
    const void* flight = nullptr;  ///< context of stateOf
    float elapsed = 0.0f;          ///< s since the start of the step
};

/// The effect of a field on a body.
struct FieldForce {
    Acceleration acceleration;
    /// Upper bound of h c + (h w)^2 / 2, with the field's damping c (1/s) and the angular frequency w (rad/s)
    /// of the oscillation that it causes. An explicit step of h is accurate up to 1, and unstable from 2 on.
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
    /// Computes the force; null if the field is not a smooth force (explosions).
    FieldForce (*force)(const FieldView& view, std::uint32_t field, std::uint32_t body,
                        const BodyState& state) = nullptr;
};

const FieldType& fieldTypeOf(FieldKind kind);

/// True if a field acts on a body at its current position.
[[nodiscard]] bool actsOn(const World& world, const FieldDefinition& field, std::uint32_t body);
/// Returns the center (m) of the region of a field. The center of an Attractor moves with its body.
[[nodiscard]] inline WorldPosition centreOf(const World& world, const FieldDefinition& field) {
    const bool follows = field.kind == FieldKind::Attractor && field.a;
    return follows ? world.bodies.pose[field.a.index].centre : field.place;
}
/// Returns the kind of region of a field; explosions always have a circle.
constexpr RegionKind regionOf(const FieldDefinition& field) {
    return field.kind == FieldKind::Explosion ? RegionKind::Circle : field.region;
}
[[nodiscard]] bool isInRegion(const FieldDefinition& field, WorldPosition place);
/// Returns the velocity (m/s) of the air of a Wind in a given step, gusts included.
[[nodiscard]] Vec2 airOf(const FieldDefinition& field, std::uint64_t step);
/// True if the acceleration depends on neither position nor velocity: trajectories have a closed form.
[[nodiscard]] constexpr bool isConstant(const FieldDefinition& field) {
    return field.kind == FieldKind::AreaGravity && field.strength == 0.0f;
}

/// True if a body has a shape on one of these layers, or if `layers` has all bits.
[[nodiscard]] bool isOnLayers(const World& world, std::uint32_t layers, std::uint32_t body);

/// Returns the acceleration of a body by all fields of a list that are not constant: for all integrators, and
/// for bodies with contacts or joints. If the fields together are too stiff for the step, the body reacts as
/// if it was heavier; its position of rest and its terminal velocity do not change.
/// @param other  acceleration by everything except these fields
Acceleration accelerationAt(const FieldView& view, std::span<const std::uint32_t> fields, std::uint32_t body,
                            const BodyState& state, const Acceleration& other);
/// Returns the state of a body `elapsed` seconds after the start of the step, if no forces act on it.
BodyState stateAfter(const World& world, std::uint32_t body, float elapsed);

FieldForce buoyancy(const FieldView&, std::uint32_t, std::uint32_t, const BodyState&);
/// Returns FieldForce::stiffness of a spring for the body at one of its ends.
[[nodiscard]] float springStiffness(const World& world, const FieldDefinition& field, std::uint32_t body,
                                    float h);

/// Returns the width (m) of a shape across a unit direction in the shape's frame.
[[nodiscard]] float widthAcross(const Geometry& geometry, std::span<const Corner> corners, Vec2 direction);
/// Returns the width (m) of a body across a direction in the world: the sum over its solid shapes.
[[nodiscard]] float widthAcross(const World& world, std::uint32_t body, Rot rotation, Vec2 direction);

/// A body in a field that has neither contacts nor joints: integrated by Settings::integrator.
struct FreeBody {
    std::uint32_t slot = 0;
    std::uint32_t body = 0;
    Acceleration steady;    ///< acceleration that depends on neither position nor velocity
    bool isSteady = false;  ///< true if there is no other acceleration: the trajectory has a closed form
    float linearDrag = 0.0f;
    float angularDrag = 0.0f;
    BodyState now;
    float turned = 0.0f;  ///< rad: rotation since the start of the step
    BodyState trial;      ///< state for which the integrator evaluates forces
    Acceleration at[4];   ///< accelerations of the integrator's stages
};

/// Ratio by which drag reduces a constant acceleration over a substep.
struct DriveScale {
    float linear = 1.0f;
    float angular = 1.0f;
};

/// The method by which a body is integrated.
enum class FieldMotion : std::uint8_t {
    Steady,  ///< by the solver: only constant accelerations act on it
    Driven,  ///< by the solver, because it has contacts or joints; fields are evaluated before each substep
    Free,    ///< by Settings::integrator
};

/// A body in a field that has contacts or joints: the solver integrates it.
struct Driven {
    std::uint32_t slot = 0;
    std::uint32_t body = 0;
    Acceleration steady;  ///< acceleration that depends on neither position nor velocity
    DriveScale scale;
    Acceleration moved;  ///< m, rad: displacement before the current substep
    float work = 0.0f;   ///< J: work of all accelerations in this step so far
};

/// Which fields act on which bodies in a step, and which bodies are integrated freely.
struct SmoothForces {
    struct Pull {  // a field that acts on the body of a slot
        std::uint32_t slot;
        std::uint32_t field;
    };
    std::vector<Pull> pulls;
    std::vector<std::uint32_t> begins;  ///< indexed by slot: start in `fields`; one more at the end
    std::vector<std::uint32_t> fields;
    /// Indexed by field: factor below 1 on the force of a spring if the springs at one of its ends are
    /// together too stiff for a step. The same factor for both ends, so that momentum is conserved.
    std::vector<float> springScales;
    std::vector<FieldMotion> motions;  ///< indexed by slot; empty in a step without fields
    std::vector<FreeBody> flyers;      ///< bodies integrated freely, by slot in ascending order
    std::vector<Driven> driven;        ///< by slot in ascending order
    /// J, indexed by slot: work on a driven body minus the work the last accelerations would do.
    std::vector<float> works;
    std::vector<std::int32_t> flyerOf;  ///< indexed by body: index in `flyers`, or -1

    [[nodiscard]] std::span<const std::uint32_t> fieldsOf(std::size_t slot) const {
        return std::span{fields}.subspan(begins[slot], begins[slot + 1] - begins[slot]);
    }
};

// Finds the fields that may act on a body by their bounding boxes: a small field costs time only where it
// overlaps bodies. Fields without bounds may act on all bodies, springs only on their own.

/// Updates Workspace::fieldBoxes after changes of fields and movements of attractors' bodies.
void updateFieldBoxes(const World& world, Workspace& work);

/// Returns the fields that may act on a body, ascending: a superset of actsOn(). Valid until the next call.
/// @param kinds  bits, 1 << FieldKind: kinds to find; the result may contain other kinds
std::span<const std::uint32_t> fieldsNear(const World& world, Workspace& work, std::uint32_t body,
                                          std::uint32_t kinds);

/// Calls act(body, field) for all awake bodies and the fields that act on them; `kinds` as for fieldsNear().
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
