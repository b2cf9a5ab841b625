#pragma once

#include "physics/model/edits.hpp"

namespace plumb::physics {

struct DetectionCounts;
struct StepContext;
struct Workspace;

/// The same for those that touch: with a trigger, or without.
template <class Act>
void forTouching(const World& world, bool triggered, Act&& act) {
    const int wanted = triggered ? kTouching | kTriggered : kTouching;
    forContacts(world, [&](const Contact& contact) {
        if ((contact.flags & (kTouching | kTriggered)) == wanted) act(contact);
    });
}

/// A contact of two shapes that do not touch yet. The one of a body that cannot be pushed comes first.
Contact makeContact(const World& world, std::uint32_t shapeA, std::uint32_t shapeB);

/// False for a border inside something, and for one that is stopped by what is in front of it.
[[nodiscard]] bool comesTo(const World& world, std::uint32_t shapeA, std::uint32_t shapeB);

/// Outward normal of the side on which a one-way shape stops what comes, in the world.
[[nodiscard]] inline Vec2 openDirection(const World& world, std::uint32_t shape) {
    const Rot rotation = world.bodies.pose[world.shapes.info[shape].body].rotation;
    return rotate(rotation, world.shapes.extrasOf(shape).oneWayDirection);
}

/// Whether a push can turn the body.
[[nodiscard]] bool canTurn(const World& world, std::uint32_t body);

/// Friction and the like, and what kind of contact it is, from its two shapes.
void copyMaterials(const World& world, Contact& contact);

/// Finds out where the shapes of contacts are to each other, and keeps what it knew of places that are still
/// the same. Contacts whose bounds have parted get kGone.
/// @param dt  s: of the step that is about to be done
void findTouches(const World& world, std::span<Contact> contacts, float dt, DetectionCounts& counts);

/// Finds where the shapes of a new contact are to each other now, up to `distance` (m) apart.
void findTouch(const World& world, Contact& contact, float distance);

/// A face of A, as the only thing of it that B touches.
struct OnlyFace {
    Vec2 normal;     ///< in A's frame
    Vec2 beyond;     ///< m: how far it goes on beyond its start and its end
    float distance;  ///< m: up to which there are points
};

/// Finds the points of a contact anew.
void touchFaceOnly(const World& world, Contact& contact, const OnlyFace& face);

void forgetPoints(Contact& contact);

/// Ends the contacts of altered shapes: they are found anew.
void endAltered(StepContext& step);
/// Friction and bounciness by the callbacks of the owner, if there are any.
void askForMaterial(const StepContext& step, Contact& contact);

/// Takes note that the shapes of a contact touch from now on.
/// @param index  in World::contacts
void beginContact(World& world, Workspace& work, std::size_t index);

/// m from A's centre of mass, in A's frame: where they touch.
/// @param point  below Contact::count
[[nodiscard]] Vec2 pointOf(const World& world, const Contact& contact, int point);

[[nodiscard]] bool isReported(const World& world, const Contact& contact);

ContactEvent eventOf(const World& world, const Contact& contact, ContactPhase phase);

// chain_events.cpp

// Shapes with one ShapeDefinition::surface form a chain, whose seams should not cause events. Contacts
// between a chain and what touches it are therefore counted: the first one to begin is an event, and so is
// the last one to end, decided at the end of the step, when it is known which contacts replaced others.

/// Makes an event of what happened to a contact, if it is reported: at once, of chains later.
/// @param impulse  N s, see ContactEvent
void report(World& world, Workspace& work, const Contact& contact, ContactPhase phase, float impulse = 0.0f);

/// Notes how fast two bodies with these motions come together at a contact, for its event.
void noteApproach(const World& world, Workspace& work, const Contact& contact, const BodyMotion& a,
                  const BodyMotion& b);

/// Makes the events of chains. Part of publishEvents().
void publishSurfaces(World& world, Workspace& work);

/// Recounts all contacts of chains, after the world was overwritten.
void countSurfaces(const World& world, Workspace& work);

// initial_overlaps.cpp

// Bodies that are put into each other (by a level, a script, a change of size) would be thrown apart. So an
// overlap that no motion explains is hidden from the solver when it begins, and shown little by little.

/// Marks a contact that begins deeper than the motion of its bodies explains: kInitialOverlap.
void markInitialOverlap(const World& world, Contact& contact);

/// Keeps how deep a marked contact is, and hides that from the solver.
void addInitialOverlap(World& world, Contact& contact);

/// Shows more of all that is hidden.
void fadeInitialOverlaps(World& world, float dt);

/// Hides from the solver what is still hidden of a marked contact; if nothing is, it is no longer marked.
void hideInitialOverlap(const World& world, Contact& contact);

// seams.cpp

/// Corrects contacts of bodies with several fixed shapes that abut: the edges between these are no border,
/// and neither a normal from one of them nor its points are valid. Part of updateContacts(). Reads:
/// work.contactFindings. Writes: contacts (points), work.endedAtSeams.
void correctSeams(StepContext& step);

/// Corrects a contact that was found for a hit, and lets a face that goes on in other fixed shapes touch as
/// one. Of what may be on its path, only what never yields has seams.
void touchUnion(StepContext& step, Contact& contact);

}  // namespace plumb::physics
