#pragma once

#include <span>
#include <vector>

#include "physics/soft/soft_rigid_contacts.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

// Contacts between soft bodies: particles of one against the edges of another, and vice versa. An edge is a
// link of SoftBody::edges, with the radii of both bodies.

/// Bounds over a step, m.
struct SoftBox {
    WorldPosition min;
    WorldPosition max;
};

/// A particle that an edge of another soft body may touch in this step.
struct SoftSoftContact {
    std::uint32_t body = 0;  ///< in World::softBodies: body of the particle
    std::uint32_t particle = 0;
    std::uint32_t other = 0;  ///< body of the edge
    std::uint32_t a = 0;      ///< ends of the edge: particles of `other`
    std::uint32_t b = 0;
    float side = 1.0f;    ///< side of the edge on which the particle belongs: 1 or -1
    bool inside = false;  ///< the particle is inside the other's ring, and this edge is the nearest one
};

struct SoftEdge {
    SoftBox box;
    std::uint32_t link = 0;
};

/// Data of a step, in Workspace.
struct SoftSoftContacts {
    std::vector<SoftBox> boxes;  ///< by index of the soft body
    std::vector<std::uint32_t>
        leaders;  ///< by index: lowest index among those that it may touch, directly or through others
    std::vector<std::uint32_t> order;  ///< existing soft bodies, sorted by leader
    std::vector<SoftEdge> edges;       ///< of one soft body near another, from left to right
    std::vector<SoftSoftContact> all;  ///< by group
};

/// Bounds of a soft body over dt seconds, without its radius.
[[nodiscard]] SoftBox boxOf(const SoftBody& body, float dt);
[[nodiscard]] inline AABB rounded(const SoftBox& box) { return {toVec2(box.min), toVec2(box.max)}; }

/// Sorts soft bodies so that those that may touch within a step of dt seconds, or push the same island, are
/// adjacent in `order`.
void groupSoftBodies(const World& world, float dt, const SoftSurroundings& around,
                     SoftSoftContacts& meetings);
/// Adds all potential contacts within a group of `order`.
void findMeetings(const World& world, float dt, std::span<const std::uint32_t> group,
                  SoftSoftContacts& meetings);
/// Separates what is too close at the end of a substep of h seconds. Conserves momentum.
void keepSoftApart(World& world, float h, std::span<const SoftSoftContact> meetings);

}  // namespace plumb::physics
