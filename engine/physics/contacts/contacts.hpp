#pragma once

#include "physics/edits.hpp"

namespace plumb::physics {

struct DetectionCounts;
struct StepContext;
struct Workspace;

/// Calls act(contact) for all touching contacts: if `triggered` those with a trigger, else those without.
template <class Act>
void forTouching(const World& world, bool triggered, Act&& act) {
    const int wanted = triggered ? kTouching | kTriggered : kTouching;
    forContacts(world, [&](const Contact& contact) {
        if ((contact.flags & (kTouching | kTriggered)) == wanted) act(contact);
    });
}

/// Returns a new contact of two shapes, without points. If one body is not dynamic, its shape becomes shapeA.
Contact makeContact(const World& world, std::uint32_t shapeA, std::uint32_t shapeB);

/// True if two shapes need a contact now: a body is dynamic and awake (or a shape is a trigger), and neither
/// shape is an inner border that the other ignores (ShapeDefinition::frontLayers).
[[nodiscard]] bool needsContact(const World& world, std::uint32_t shapeA, std::uint32_t shapeB);

/// Returns the world-space outward normal of the side on which a one-way shape is solid.
[[nodiscard]] inline Vec2 openDirection(const World& world, std::uint32_t shape) {
    const Rot rotation = world.bodies.pose[world.shapes.info[shape].body].rotation;
    return rotate(rotation, world.shapes.extrasOf(shape).oneWayDirection);
}

/// True if an impulse can rotate the body.
[[nodiscard]] inline bool canRotate(const World& world, std::uint32_t body) {
    return isDynamic(world, body) && (world.bodies.info[body].flags & kFixedRotation) == 0;
}

/// Computes friction and other material properties of the contact from its two shapes, and derives its flags.
void copyMaterials(const World& world, Contact& contact);

/// Narrow phase: computes the points of contacts, or reuses the previous points if the bodies hardly moved.
/// Contacts whose bounds no longer overlap get the flag kGone.
/// @param dt  s: length of the current step
void findTouches(const World& world, std::span<Contact> contacts, float dt, DetectionCounts& counts);

/// Computes the points of a new contact at the current poses: those with separations up to `distance` (m).
void findTouch(const World& world, Contact& contact, float distance);

/// Restricts a contact to one face of A.
struct OnlyFace {
    Vec2 normal;     ///< outward normal of the face, in A's frame
    Vec2 beyond;     ///< m: length added to the face at its start (x) and at its end (y)
    float distance;  ///< m: maximum separation of contact points
};

/// Recomputes the points of a contact with the given face only.
void touchFaceOnly(const World& world, Contact& contact, const OnlyFace& face);

inline void clearPoints(Contact& contact) {
    contact.count = 0;
    contact.impulse0 = contact.impulse1 = contact.frictionImpulse = contact.rollingImpulse = 0.0f;
}

/// Ends the contacts of the shapes in World::altered; the broad phase finds them again.
void endAltered(StepContext& step);
/// Sets friction and bounciness of a contact by the callbacks in ContactHooks, if these are set.
void askForMaterial(const StepContext& step, Contact& contact);

/// Marks a contact as touching from now on.
/// @param index  index of the contact in World::contacts
void beginContact(World& world, Workspace& work, std::size_t index);

/// Returns the position (m) of a contact point relative to A's centre of mass, in A's frame.
/// @param point  index of the point, below Contact::count
[[nodiscard]] Vec2 pointOf(const World& world, const Contact& contact, int point);

// chain_events.cpp

// Shapes with the same ShapeDefinition::surface form a chain, whose seams should not cause events. So
// contacts between a chain and another shape are counted: only the first to begin and the last to end cause
// an event. Which ones these are is known only at the end of the step, when all contacts have begun or ended.

/// Creates the event of a contact that reports events: at once, or for chains at the end of the step.
/// @param impulse  N s, see ContactEvent
void report(World& world, Workspace& work, const Contact& contact, ContactPhase phase, float impulse = 0.0f);

/// Records the approach speed of bodies A and B, with motions `a` and `b`, for the event of a contact.
void noteApproach(const World& world, Workspace& work, const Contact& contact, const BodyMotion& a,
                  const BodyMotion& b);

/// Creates the events of chains. Part of publishEvents().
void publishSurfaces(World& world, Workspace& work);

/// Recounts all contacts of chains, after the world was overwritten.
void countSurfaces(const World& world, Workspace& work);

// initial_overlaps.cpp

// Bodies placed inside each other (by a level, a script, a change of size) would be thrown apart. So an
// overlap too deep to result from motion is hidden from the solver at first and revealed gradually.

/// Sets kInitialOverlap on a new contact if its overlap is too deep to result from the motion of its bodies.
void markInitialOverlap(const World& world, Contact& contact);

/// Records the depth of a contact with kInitialOverlap and hides it from the solver.
void addInitialOverlap(World& world, Contact& contact);

/// Reduces the hidden part of all initial overlaps.
void fadeInitialOverlaps(World& world, float dt);

/// Subtracts the hidden depth from a contact with kInitialOverlap; removes this flag once nothing is hidden.
void hideInitialOverlap(const World& world, Contact& contact);

// seams.cpp

/// Corrects the contacts of a body with several adjacent static or kinematic shapes: edges between adjacent
/// shapes are interior, so contact points on them and their normals are invalid. Part of updateContacts().
/// Reads: work.contactFindings. Writes: contacts (points), work.endedAtSeams.
void correctSeams(StepContext& step);

/// Recomputes normal and points of a contact that was made for a hit on the path of a body, with its face
/// extended over adjacent static or kinematic shapes that continue the face.
void touchUnion(StepContext& step, Contact& contact);

}  // namespace plumb::physics
