#pragma once

#include "physics/solver/contact_block.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

struct StepContext;

// Contacts of particles with rigid bodies: constraints of the solver's substeps, with the mass of both sides.
// As accelerate() does for bodies, particles repeat the impulses of the previous substep (warm starting).

/// A rigid body near soft bodies of one group.
struct SoftObstacle {
    std::uint32_t body = 0;
    bool isPushed = false;        ///< it is dynamic and awake
    std::int32_t slot = -1;       ///< in the solver, if it is pushed
    Vec2 inverseMass;             ///< 1/kg along x and y; 0 if it is locked or not pushed
    float inverseInertia = 0.0f;  ///< 1/(kg m2)
    WorldPosition centre;         ///< m: at the start of the substep
    Rot rotation;
    float pressed = 0.0f;  ///< N s: sum of the impulses of its contacts, without their directions
    Float4 motion;         ///< m/s, m/s, rad/s: of a body without a slot
};

/// A particle that a shape may touch in this step.
struct SoftContact {
    SoftBody* soft = nullptr;
    SoftParticle* particle = nullptr;
    std::uint32_t shape = 0;
    std::uint32_t obstacle = 0;
    Vec2 impulse;      ///< N s: on the particle, in a substep
    Vec2 normal;       ///< away from the body
    Vec2 arm;          ///< m: from the body's center to the particle
    float gap = 0.0f;  ///< m: at the start of the substep
};

struct SoftRange {
    std::size_t begin = 0;
    std::size_t end = 0;

    template <class T>
    [[nodiscard]] std::span<T> of(std::vector<T>& list) const {
        return std::span{list}.subspan(begin, end - begin);
    }
};

/// Soft bodies that may touch each other or the same island in this step: solved together.
struct SoftGroup {
    SoftRange bodies;     ///< of SoftSoftContacts::order
    SoftRange meetings;   ///< of SoftSoftContacts::all
    SoftRange obstacles;  ///< of the following lists
    SoftRange contacts;
    int substeps = 1;            ///< number that it needs
    std::uint32_t body = kNone;  ///< one of the bodies that it may push
};

struct SoftSurroundings {
    std::vector<std::uint32_t> shapes;  ///< near soft bodies, in the order of these
    std::vector<std::uint32_t> ends;    ///< by soft body: end of its range in `shapes`
    /// Islands near soft bodies that can push them: root and index in World::softBodies, sorted.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours;
    std::vector<SoftObstacle> obstacles;  ///< by group, then by body
    std::vector<SoftContact> contacts;    ///< by group and soft body, then by shape and particle
    std::vector<SoftGroup> groups;
    std::vector<std::uint32_t> obstacleOf;  ///< by body: index in `obstacles` + 1, until they are solved

    [[nodiscard]] std::span<const std::uint32_t> shapesOf(std::uint32_t soft) const {
        const std::uint32_t begin = soft > 0 ? ends[soft - 1] : 0;
        return std::span{shapes}.subspan(begin, ends[soft] - begin);
    }
    /// True if soft bodies may push this body in this step.
    [[nodiscard]] bool holds(std::uint32_t body) const {
        return body < obstacleOf.size() && obstacleOf[body] != 0;
    }
};

/// Finds the shapes near all soft bodies, wakes bodies that they hit, and finds islands that they share.
void findSurroundings(StepContext& step);
void findSoftContacts(StepContext& step, SoftGroup& group);
/// Number of substeps of a group, such that its links can carry the loads on them.
[[nodiscard]] int substepsOf(const StepContext& step, const SoftGroup& group);
/// Updates positions at the start of a substep. @param elapsed s since the start of the step
void measureSoftContacts(StepContext& step, const SoftGroup& group, float elapsed);
/// Applies the impulses of the last substep: to the particles, and in the first one to the bodies too.
void warmStartSoft(StepContext& step, const SoftGroup& group, float h, bool first);
/// One pass over soft contacts. The biased pass moves particles, the relax pass changes their velocities.
void solveSoft(StepContext& step, const SoftGroup& group, const ContactPass& pass, bool relax);
/// Stores the forces of the last substep for the next step.
void storeSoftContacts(StepContext& step, const SoftGroup& group, float h);

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

/// Makes soft bodies that may touch within a step of dt seconds, or push one island, adjacent in `order`.
void groupSoftBodies(const World& world, float dt, const SoftSurroundings& around,
                     SoftSoftContacts& meetings);
/// Adds all potential contacts within a group of `order`.
void findMeetings(const World& world, float dt, std::span<const std::uint32_t> group,
                  SoftSoftContacts& meetings);
/// Separates what is too close at the end of a substep of h seconds. Conserves momentum.
void keepSoftApart(World& world, float h, std::span<const SoftSoftContact> meetings);

}  // namespace plumb::physics
