#pragma once

#include "core/fixed_list.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// Relations between objects. Results replace the content of `found`; for an object that is gone it is empty.

/// In the order in which they were created.
void shapesOf(const World& world, BodyId body, std::vector<ShapeId>& found);
void jointsOf(const World& world, BodyId body, std::vector<JointId>& found);

/// The touching contacts of a body or a shape, without triggers, including sleeping ones. Valid until
/// the world changes. Visits all contacts of the world: to track many bodies, use World::events.
void contactsOf(const World& world, BodyId body, std::vector<const Contact*>& found);
void contactsOf(const World& world, ShapeId shape, std::vector<const Contact*>& found);
/// The shapes that overlap a trigger, as of the last step.
void overlapsOf(const World& world, ShapeId trigger, std::vector<ShapeId>& found);

/// The bodies that the last step moved. Those in World::fellAsleep have now come to rest.
void movedBodies(const World& world, std::vector<BodyId>& found);

/// Where two shapes touch.
struct ContactPoint {
    WorldPosition point;      ///< m: midway between the two surfaces
    float separation = 0.0f;  ///< m along the normal of the contact; negative: overlap
    float impulse = 0.0f;     ///< N s along the normal, of the last substep
};
/// The points of a contact: Contact::count of them, 0 to 2.
[[nodiscard]] FixedList<ContactPoint, 2> contactPoints(const World& world, const Contact& contact);

/// m: bounding box of the shapes of a body, as the broad phase has them (with margins); all 0 if there is
/// none.
[[nodiscard]] AABB boundsOf(const World& world, BodyId body);
/// m: of all shapes of the world; both corners (0, 0) if there is none.
[[nodiscard]] AABB boundsOf(const World& world);

}  // namespace plumb::physics
