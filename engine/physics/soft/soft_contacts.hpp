#pragma once

#include "physics/solver/contact_block.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

struct StepContext;

// Contacts of particles with rigid bodies: constraints that the solver solves in each substep, with the
// masses of both sides. Each substep begins with the impulses of the previous one (warm starting).

/// A rigid body near soft bodies of a group.
struct SoftObstacle {
    std::uint32_t body = 0;
    bool isPushed = false;        ///< it is dynamic and awake
    std::int32_t slot = -1;       ///< solver slot; -1 if it is not pushed
    Vec2 inverseMass;             ///< 1/kg along x and y; 0 if it is locked or not dynamic; also asleep
    float inverseInertia = 0.0f;  ///< 1/(kg m2)
    WorldPosition centre;         ///< m: center of mass at the start of the substep
    Rot rotation;
    float pressed = 0.0f;  ///< N s: sum of the magnitudes of its contact impulses
    Float4 motion;         ///< velocity x, y (m/s) and angular velocity (rad/s), if not dynamic
};

/// Potential contact of a particle with a shape in this step.
struct SoftContact {
    SoftBody* soft = nullptr;
    SoftParticle* particle = nullptr;
    std::uint32_t shape = 0;     ///< index of the shape
    std::uint32_t obstacle = 0;  ///< its body: index in SoftSurroundings::obstacles
    Vec2 impulse;                ///< N s: on the particle, in a substep
    Vec2 normal;                 ///< unit length, from the body to the particle
    Vec2 arm;  ///< m: from the body's center to the particle, at the start of the step as in all contacts
    float gap = 0.0f;  ///< m: distance minus the radius, at the start of the substep
};

struct SoftRange {  // indices begin to end - 1 of a list
    std::size_t begin = 0;
    std::size_t end = 0;

    template <class T>
    [[nodiscard]] std::span<T> of(std::vector<T>& list) const {
        return std::span{list}.subspan(begin, end - begin);
    }
};

/// Soft bodies that may touch each other or the same island in this step, and are therefore solved together.
struct SoftGroup {
    SoftRange bodies;            ///< range of SoftSoftContacts::order
    SoftRange meetings;          ///< range of SoftSoftContacts::all
    SoftRange obstacles;         ///< range of SoftSurroundings::obstacles
    SoftRange contacts;          ///< range of SoftSurroundings::contacts
    int substeps = 1;            ///< number of substeps that it requires
    std::uint32_t body = kNone;  ///< one of the rigid bodies that it may push; kNone: there is none
};

struct SoftSurroundings {
    std::vector<std::uint32_t> shapes;  ///< shapes near soft bodies, grouped by soft body
    std::vector<std::uint32_t> ends;    ///< per soft body: end of its range in `shapes`
    /// Sorted pairs: an island (its root) and a soft body near it that can push it (index in softBodies).
    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours;
    std::vector<SoftObstacle> obstacles;  ///< sorted by group, then by body
    std::vector<SoftContact> contacts;    ///< sorted by group, soft body, shape and particle
    std::vector<SoftGroup> groups;
    std::vector<std::uint32_t> obstacleOf;  ///< indexed by body: index in `obstacles` + 1; 0: none

    [[nodiscard]] std::span<const std::uint32_t> shapesOf(std::uint32_t soft) const {
        const std::uint32_t begin = soft > 0 ? ends[soft - 1] : 0;
        return std::span{shapes}.subspan(begin, ends[soft] - begin);
    }
    /// True if soft bodies may push this body in this step.
    [[nodiscard]] bool holds(std::uint32_t body) const {
        return body < obstacleOf.size() && obstacleOf[body] != 0;
    }
};

/// Finds the shapes and islands near all soft bodies, and wakes bodies that they hit.
void findSurroundings(StepContext& step);
void findSoftContacts(StepContext& step, SoftGroup& group);
/// Returns the number of substeps of a group with which its links can carry the loads on them.
[[nodiscard]] int substepsOf(const StepContext& step, const SoftGroup& group);
/// Updates normals and gaps at the start of a substep, `elapsed` seconds after the start of the step.
void measureSoftContacts(StepContext& step, const SoftGroup& group, float elapsed);
/// Applies the impulses of the last substep to the particles; in the first substep also to the bodies.
void warmStartSoft(StepContext& step, const SoftGroup& group, float h, bool first);
/// Performs one pass over soft contacts. The biased pass moves particles, the relax pass changes velocities.
void solveSoft(StepContext& step, const SoftGroup& group, const ContactPass& pass, bool relax);
/// Stores the forces of the last substep for the next step.
void storeSoftContacts(StepContext& step, const SoftGroup& group, float h);

// Contacts between soft bodies: particles of one against the edges of another, and vice versa. An edge is a
// link with SoftLink::isEdge, thickened by the radii of both bodies.

/// Bounding box over a step, m.
struct SoftBox {
    WorldPosition min;
    WorldPosition max;
};

/// Potential contact of a particle with an edge of another soft body in this step.
struct SoftSoftContact {
    std::uint32_t body = 0;  ///< body of the particle: index in World::softBodies
    std::uint32_t particle = 0;
    std::uint32_t other = 0;  ///< body of the edge
    std::uint32_t a = 0;      ///< ends of the edge: particles of `other`
    std::uint32_t b = 0;
    float side = 1.0f;    ///< side of the edge on which the particle belongs: 1 or -1
    bool inside = false;  ///< the particle is inside the outline of `other`; this edge is the nearest
};

struct SoftEdge {
    SoftBox box;             ///< bounds of the edge over the step
    std::uint32_t link = 0;  ///< index in SoftBody::links
};

struct SoftSoftContacts {
    std::vector<SoftBox> boxes;          ///< bounds, indexed by soft body
    std::vector<std::uint32_t> leaders;  ///< indexed by soft body: lowest soft body of its group
    std::vector<std::uint32_t> order;    ///< existing soft bodies, sorted by leader
    std::vector<SoftEdge> edges;         ///< edges of one soft body near another, from left to right
    std::vector<SoftSoftContact> all;    ///< all potential contacts, by group
};

/// Returns the bounds of a soft body over dt seconds, without its radius.
[[nodiscard]] SoftBox boxOf(const SoftBody& body, float dt);
[[nodiscard]] inline AABB rounded(const SoftBox& box) { return {toVec2(box.min), toVec2(box.max)}; }

/// Sorts `order`: soft bodies that may touch within dt seconds, or push the same island, become adjacent.
void groupSoftBodies(const World& world, float dt, const SoftSurroundings& around,
                     SoftSoftContacts& meetings);
/// Appends all potential contacts between the soft bodies of a group to `meetings.all`.
void findMeetings(const World& world, float dt, std::span<const std::uint32_t> group,
                  SoftSoftContacts& meetings);
/// Separates particles and edges that are too close after a substep of h seconds. Conserves momentum.
void keepSoftApart(World& world, float h, std::span<const SoftSoftContact> meetings);

}  // namespace plumb::physics
