#pragma once

#include <span>

#include "physics/model/edits.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

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

/// False for a border inside something, and one who is stopped by what is before it.
[[nodiscard]] bool comesTo(const World& world, std::uint32_t shapeA, std::uint32_t shapeB);

/// Whether a push can turn the body.
[[nodiscard]] bool canTurn(const World& world, std::uint32_t body);

/// Friction and the like, and what kind of contact it is, from its two shapes.
void copyMaterials(const World& world, Contact& contact);

/// Finds out where the shapes of contacts are to each other, and keeps what it knew of places that are still
/// the same. Contacts whose bounds have parted get kGone.
/// @param dt  s: of the step that is about to be done
void findTouches(const World& world, std::span<Contact> contacts, float dt, struct DetectionCounts& counts);

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

/// Leaves a contact without points.
void forgetPoints(Contact& contact);

/// Ends the contacts of altered shapes: they are found anew.
void endAltered(struct StepContext& step);
/// Friction and bounciness by the callbacks of the owner, if there are any.
void askForMaterial(const struct StepContext& step, Contact& contact);

/// Takes note that the shapes of a contact touch from now on.
/// @param index  in World::contacts
void beginContact(World& world, struct Workspace& work, std::size_t index);

/// m from A's centre of mass, in A's frame: where they touch.
/// @param point  below Contact::count
[[nodiscard]] Vec2 pointOf(const World& world, const Contact& contact, int point);

/// True when somebody wants to hear of the contact.
[[nodiscard]] bool isReported(const World& world, const Contact& contact);

/// The event that tells of a contact.
ContactEvent eventOf(const World& world, const Contact& contact, ContactPhase phase);

}  // namespace plumb::physics
