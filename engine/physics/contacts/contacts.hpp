#pragma once

#include "physics/edits.hpp"

namespace plumb::physics {

struct DetectionCounts;
struct StepContext;
struct Workspace;

/// Calls act(contact) for all touching contacts: those with a trigger, or those without.
template <class Act>
void forTouching(const World& world, bool triggered, Act&& act) {
    const int wanted = triggered ? kTouching | kTriggered : kTouching;
    forContacts(world, [&](const Contact& contact) {
        if ((contact.flags & (kTouching | kTriggered)) == wanted) act(contact);
    });
}

/// A new contact of two shapes that do not touch yet. If one body is not dynamic, its shape comes first.
Contact makeContact(const World& world, std::uint32_t shapeA, std::uint32_t shapeB);

/// False if two shapes need no contact now: none awake or dynamic (except triggers), or an inner border.
[[nodiscard]] bool comesTo(const World& world, std::uint32_t shapeA, std::uint32_t shapeB);

/// World-space outward normal of the side on which a one-way shape is solid.
[[nodiscard]] inline Vec2 openDirection(const World& world, std::uint32_t shape) {
    const Rot rotation = world.bodies.pose[world.shapes.info[shape].body].rotation;
    return rotate(rotation, world.shapes.extrasOf(shape).oneWayDirection);
}

/// True if an impulse can rotate the body.
[[nodiscard]] bool canTurn(const World& world, std::uint32_t body);

/// Copies friction and other material properties from the two shapes, and derives the flags of the contact.
void copyMaterials(const World& world, Contact& contact);

/// Narrow phase: computes the points of contacts, or reuses those of bodies
/// that hardly moved. Contacts whose bounds no longer overlap get kGone.
/// @param dt  s: length of the step that is about to begin
void findTouches(const World& world, std::span<Contact> contacts, float dt, DetectionCounts& counts);

/// Computes the points of a new contact at the current poses, with separations up to `distance` (m).
void findTouch(const World& world, Contact& contact, float distance);

/// A face of A that is treated as the only part of A that B touches.
struct OnlyFace {
    Vec2 normal;     ///< in A's frame
    Vec2 beyond;     ///< m: by how much the face is extended at its start and its end
    float distance;  ///< m: maximum separation of its points
};

/// Recomputes the points of a contact with that face only.
void touchFaceOnly(const World& world, Contact& contact, const OnlyFace& face);

void forgetPoints(Contact& contact);

/// Ends the contacts of altered shapes; the broad phase finds them again.
void endAltered(StepContext& step);
/// Sets friction and bounciness by the owner's callbacks, if there are any.
void askForMaterial(const StepContext& step, Contact& contact);

/// Marks a contact as touching from now on.
/// @param index  in World::contacts
void beginContact(World& world, Workspace& work, std::size_t index);

/// m from A's centre of mass, in A's frame: position of a contact point.
/// @param point  below Contact::count
[[nodiscard]] Vec2 pointOf(const World& world, const Contact& contact, int point);

// chain_events.cpp

// Shapes with one ShapeDefinition::surface form a chain, whose seams should not cause events. So contacts
// between a chain and another shape are counted: only the first to begin and the last to end cause an
// event. That is decided at the end of the step, when it is known which contacts replaced others.

/// Creates the event of a contact, if it is reported: at once, or for chains at the end of the step.
/// @param impulse  N s, see ContactEvent
void report(World& world, Workspace& work, const Contact& contact, ContactPhase phase, float impulse = 0.0f);

/// Records the approach speed of two bodies with these motions at a contact, for its event.
void noteApproach(const World& world, Workspace& work, const Contact& contact, const BodyMotion& a,
                  const BodyMotion& b);

/// Creates the events of chains. Part of publishEvents().
void publishSurfaces(World& world, Workspace& work);

/// Recounts all contacts of chains, after the world was overwritten.
void countSurfaces(const World& world, Workspace& work);

// initial_overlaps.cpp

// Bodies that are placed inside each other (by a level, a script, a change of size) would be thrown
// apart. So an overlap that no motion explains is hidden from the solver at first and revealed gradually.

/// Sets kInitialOverlap on a new contact that is deeper than the motion of its bodies explains.
void markInitialOverlap(const World& world, Contact& contact);

/// Records the depth of a marked contact and hides it from the solver.
void addInitialOverlap(World& world, Contact& contact);

/// Reduces the hidden part of all initial overlaps.
void fadeInitialOverlaps(World& world, float dt);

/// Applies the hidden part of a marked contact; removes the mark if nothing is hidden any more.
void hideInitialOverlap(const World& world, Contact& contact);

// seams.cpp

/// Corrects contacts of bodies with several adjacent static or kinematic shapes: the edges between
/// adjacent shapes are interior, so normals from them and their points are invalid. Part of
/// updateContacts(). Reads: work.contactFindings. Writes: contacts (points), work.endedAtSeams.
void correctSeams(StepContext& step);

/// Corrects a contact that was computed for a hit of a sweep, and extends its face
/// over adjacent static or kinematic shapes that continue it. Only these have seams.
void touchUnion(StepContext& step, Contact& contact);

}  // namespace plumb::physics
