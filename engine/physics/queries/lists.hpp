#pragma once

#include "core/fixed_list.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// Lists of objects that belong together. Results replace the content of `found`; empty for a stale id.

/// Shapes and joints in the order of their creation.
void shapesOf(const World& world, BodyId body, std::vector<ShapeId>& found);
void jointsOf(const World& world, BodyId body, std::vector<JointId>& found);

/// The touching contacts of a body or a shape, without triggers, including sleeping ones. Valid until
/// the world changes. Visits all contacts of the world: to track many bodies, use World::events.
void contactsOf(const World& world, BodyId body, std::vector<const Contact*>& found);
void contactsOf(const World& world, ShapeId shape, std::vector<const Contact*>& found);
/// Finds the shapes that overlapped a trigger in the last step.
void overlapsOf(const World& world, ShapeId trigger, std::vector<ShapeId>& found);

/// Finds the bodies that the last step moved, including those that fell asleep in it.
void movedBodies(const World& world, std::vector<BodyId>& found);

/// A point at which two shapes touch.
struct ContactPoint {
    WorldPosition point;      ///< m: midway between the two surfaces
    float separation = 0.0f;  ///< m along the normal of the contact; negative: overlap
    float impulse = 0.0f;     ///< N s along the normal, of the last substep
};
/// Returns the 0 to 2 points of a contact.
[[nodiscard]] FixedList<ContactPoint, 2> contactPoints(const World& world, const Contact& contact);

/// Returns the bounding box (m) of a body's shapes, with margins; all 0 without shapes.
[[nodiscard]] AABB boundsOf(const World& world, BodyId body);
/// Returns the bounding box (m) of all shapes of the world, with margins; all 0 without shapes.
[[nodiscard]] AABB boundsOf(const World& world);

}  // namespace plumb::physics
